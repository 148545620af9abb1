#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/service.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// What the services of `simulation` and `time` need from the program around the simulation.
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

  /// To be called after each Act(): wakes those whose `time sleep` is over.
  void TimeAdvanced();

  /// Components that have a socket stream, by full name (what list_streams shows).
  static bool HasStream(const sim::Component& component);

 private:
  using Table =
      std::map<std::string, std::map<std::string, sim::Service, std::less<>>, std::less<>>;

  void AddComponentServices(sim::Component& component);
  void AddSimulationServices();
  void AddTimeServices();
  void AddCommunicationServices();
  void Add(const std::string& component, sim::Service service);
  Json Details() const;
  Json SceneObjects() const;
  void PlaceObject(sim::Arguments arguments);
  sim::Component& ComponentArgument(sim::Arguments arguments, const char* verb) const;

  sim::Simulation& simulation_;
  RunControl control_;
  Table services_;
  Vec3 camera_;
  double alarm_ = 0.0;  // s, simulated; of the one sleeper
  sim::Completion sleeper_;
};

}  // namespace ccmorse::servers
