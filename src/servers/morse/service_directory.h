#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "servers/sample_use.h"
#include "sim/own/own_component.h"
#include "sim/service.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// How time is to go on, for those who show it.
struct TimeState {
  bool paused = false;
  double speed = 1.0;    ///< simulated seconds per wall-clock second; infinity: as many as can be
  bool jumping = false;  ///< on the way to another time of a record: nothing to be shown
};

/// What the services of `simulation`, `time` and `ccmorse` need from the program around the
/// simulation.
struct RunControl {
  /// Port of a component's stream, 0 when it has none.
  std::function<int(const sim::Component&)> stream_port;
  /// Ends the run (`quit`, `terminate`).
  std::function<void()> quit;
  /// "Best Effort" or "Fixed Simulation Step", as MORSE names them.
  std::function<std::string()> time_mode;
  /// What `time statistics` answers.
  std::function<Json()> time_statistics;
  /// Changes simulated seconds per wall second; false when the pace has no such factor.
  std::function<bool(double)> set_time_scale;

  // Of `ccmorse`; where one is not there, its service fails.
  /// Stops time and lets it go on (`pause`, `resume`).
  std::function<void(bool)> set_paused;
  /// Lets so many more ticks by and stops then; the number of the tick after them (`step`).
  std::function<std::uint64_t(int)> step;
  /// Simulated seconds per wall-clock second, infinity for as many as can be (`set_speed`).
  std::function<void(double)> set_speed;
  /// To a simulated second of a record (`seek`). It must not happen within the call.
  std::function<void(double)> seek;
  std::function<TimeState()> time_state;
};

/// Something from outside that changes what is simulated. The views live for the call that hands
/// them on.
struct Input {
  enum class Kind {
    kService,    ///< a call of a service
    kBytes,      ///< a call of a service with arguments in bytes, over the fast link
    kStream,     ///< a message of an actuator's stream
    kInterrupt,  ///< the end of a component's asynchronous service (`cancel`)
    kOwn,        ///< what the code of a component of one's own has done (own/own_change.h)
  };
  Kind kind = Kind::kService;
  std::string_view component;  ///< "s1r.motion", or "simulation"
  std::string_view service;    ///< of a call
  std::string arguments;  ///< JSON: the list of a call's arguments, the stream's message, or what
                          ///< own code has done; the bytes as base64
};

/// Every service that can be called over MORSE's socket protocol, by component and name, with
/// MORSE's rules for parameters and its error texts (specs: morse.md A.5, A.8-A.11). Knows no
/// socket.
class ServiceDirectory {
 public:
  ServiceDirectory(sim::Simulation& simulation, RunControl control);

  /// A service that was looked up once, to be called often. Valid as long as the directory.
  struct Target {
    const std::string* component = nullptr;  ///< full name
    const sim::Service* service = nullptr;   ///< nullptr: there is none of that name
  };
  Target Find(std::string_view component, std::string_view service) const;
  /// What a call of a service that is not there is answered with.
  static std::string NotRegistered(std::string_view service);

  /// Runs a service; `done` is called once, now or when an asynchronous service ends. `parameters`
  /// is the raw text behind the service's name. Never throws on bad input: that is a kFailed
  /// result.
  void Call(std::string_view component, std::string_view service, std::string_view parameters,
            const sim::Completion& done);
  /// The same with arguments that were parsed already: every call comes through here, or through
  /// RunBytes(). Precondition: there is such a service.
  void Run(const Target& target, sim::Arguments arguments, const sim::Completion& done);
  /// The same for a service that takes bytes (sim::Service::bytes); kFailed when it does not.
  void RunBytes(const Target& target, std::string_view bytes, const sim::Completion& done);

  /// One more service, of a component or of something that is called like one; before the run.
  void Add(const std::string& component, sim::Service service);

  /// Has anything services by that name?
  bool HasServices(std::string_view component) const {
    return services_.find(component) != services_.end();
  }
  /// What Interrupt() calls for something that is called like a component; before the run. It is no
  /// input of the run.
  void AddInterrupt(const std::string& component, std::function<void()> interrupt) {
    interrupts_[component] = std::move(interrupt);
  }

  /// Gives an actuator a message of its stream. Throws WrongArgument when it is not what the
  /// actuator needs.
  void Receive(sim::Actuator& actuator, const Json& message);

  /// Ends the running asynchronous service of a component as PREEMPTED; nothing where none runs or
  /// there is no such component.
  void Interrupt(std::string_view component);

  /// Does what the code of a component of one's own wants done. Throws Error when it is nothing
  /// that can be done, and does none of it then.
  void ChangeOwn(sim::OwnComponent& component, const Json& change);

  /// Is told of every input in the order in which they are applied, just before each. The
  /// functions above are the only door for what comes from outside.
  using InputTap = std::function<void(const Input&)>;
  void set_input_tap(InputTap tap) { input_tap_ = std::move(tap); }

  /// Applies an input as it was when the tap was told of it; whatever it answers is dropped. Throws
  /// Error when it is none that a tap is ever told of.
  void Apply(const Input& input);

  // --- Contests: the robots' programs are judged, and nobody else is there.

  /// A call that a contest does not allow.
  struct Refusal {
    std::uint64_t tick = 0;
    std::string component;
    std::string service;
  };
  static constexpr std::size_t kMostRefusals = 100;

  /// From now on fails what changes the world beside a robot's own devices (teleporting, physics,
  /// the arena's obstacles, a scanner's made-up ranges) and what tells where its obstacles are. The
  /// tap hears of the first kMostRefusals such calls, so that they are in a record, and a replay
  /// that is in a contest, too, finds them again.
  void set_contest(bool contest) { contest_ = contest; }
  bool contest() const { return contest_; }
  /// The first kMostRefusals of them.
  const std::vector<Refusal>& refusals() const { return refusals_; }

  /// Robots that other simulators have (specs: morse.md A.7): they are in the scene, and no more.
  /// Before the run.
  void set_external(std::set<std::string> robots) { external_ = std::move(robots); }

  /// How time is to go on now.
  TimeState time_state() const;

  /// To be called after each Act(): wakes those whose `time sleep` or `ccmorse step` is over.
  void TimeAdvanced();

  /// Which samples clients were given, for the run's report.
  SampleUse& sample_use() { return sample_use_; }

  /// Components that have a socket stream, by full name (what list_streams shows).
  static bool HasStream(const sim::Component& component);

 private:
  using Table =
      std::map<std::string, std::map<std::string, sim::Service, std::less<>>, std::less<>>;

  void AddComponentServices(sim::Component& component);
  void AddSimulationServices();
  void AddTimeServices();
  void AddCommunicationServices();
  void AddRunServices();
  void AddStreamServices();
  void AddObjectServices();
  void AddCameraServices();
  void AddRobotServices(sim::Robot& robot);
  void Start(const Target& target, sim::Arguments arguments, const sim::Completion& done);
  /// The same for one that changes nothing simulated.
  void AddQuery(const std::string& component, sim::Service service);
  bool IsExternal(const sim::Robot& robot) const { return external_.count(robot.name()) != 0; }
  Json Details() const;
  Json SceneObjects() const;
  bool IsRefused(std::string_view component, std::string_view service) const;
  void NoteRefusal(std::string_view component, std::string_view service);
  void PlaceObject(sim::Arguments arguments);
  void MirrorPose(sim::Arguments arguments);
  sim::Component& ComponentArgument(sim::Arguments arguments, const char* verb) const;

  sim::Simulation& simulation_;
  RunControl control_;
  Table services_;
  SampleUse sample_use_;
  std::array<double, 16> camera_{};      // 4 x 4, by rows: where the view's camera stands
  std::array<double, 16> projection_{};  // 4 x 4, by rows: how it sees
  // The asynchronous service that runs on a component.
  struct Running {
    std::string service;
    sim::WhileRunning policy = sim::WhileRunning::kPreempts;
    bool over = false;
  };
  std::map<std::string, std::shared_ptr<Running>, std::less<>> running_;
  double alarm_ = 0.0;  // s, simulated; of the one sleeper
  sim::Completion sleeper_;
  struct Stepper {
    std::uint64_t until;  // this tick
    sim::Completion done;
  };
  std::vector<Stepper> steppers_;
  std::set<std::string> external_;
  std::map<std::string, std::function<void()>, std::less<>> interrupts_;
  InputTap input_tap_;
  bool contest_ = false;
  std::vector<Refusal> refusals_;
};

}  // namespace ccmorse::servers
