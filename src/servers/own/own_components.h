#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "servers/morse/service_directory.h"
#include "servers/own/code_host.h"
#include "servers/run_participant.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

/// How the code of components of one's own is run.
struct OwnOptions {
  std::string python;              ///< path of the python3; needed where a component is in Python
  std::string python_folder;       ///< that holds our package morse
  double time_limit = 1.0;         ///< s of wall-clock time that one activation or call may last
  double start_time_limit = 20.0;  ///< s likewise for all of them to be made
};

/// Runs the components of one's own and the overlays in a simulation, in lock-step with its ticks:
/// sensors that are due after all others have looked, actuators before all others act, services
/// when they are called. What their code does goes through the directory of services. A component
/// whose code raises, hangs or crashes is switched off, with a line in the log, and the simulation
/// goes on. An overlay is told that a service which it has started has ended before the next
/// sensors or actuators of one's own are due. Not thread safe.
class OwnComponents : public RunParticipant, private sim::OwnCode {
 public:
  /// Starts what their code runs in and has it made. Throws Error: no python3, say; what a
  /// component's own code does wrong only switches that one off. Both outlive it.
  OwnComponents(sim::Simulation& simulation, ServiceDirectory& directory,
                const OwnOptions& options);
  ~OwnComponents() override;

  /// Has a simulation any?
  static bool AreThere(const scene::Scenario& scenario);

  void Sensed() override;
  void BeforeAct() override;

 private:
  Json Call(sim::OwnComponent& component, const std::string& service,
            sim::Arguments arguments) override;
  void Start(sim::OwnComponent& component, const std::string& service, sim::Arguments arguments,
             sim::Completion done) override;
  void Interrupt(sim::OwnComponent& component) override;

  CodeHost& HostOf(const OwnTask& task);
  bool IsOff(const OwnTask& task);
  void AddOverlays();
  void Register(Overlay& overlay, const std::string& name);
  void SwitchOff(Overlay& overlay, const std::string& reason);
  // Throws ServiceFailed for a component that is off, or a call from within its own code.
  OwnAnswer PerformOne(OwnTask task);
  Json CallOne(const OwnTask& task);
  void StartOne(OwnTask task, sim::Completion done);
  void InterruptOne(const OwnTask& task);
  void Perform(std::vector<OwnTask>& tasks);
  void Take(const OwnTask& task, const OwnAnswer& answer);
  void SwitchOff(sim::OwnComponent& component, const std::string& reason);
  // Whoever waits for one of its services is told that it failed.
  void EndServices(const void* of, const std::string& reason);
  Json Ask(const Json& question);
  Json AskToStart(const ServiceDirectory::Target& target, const Json::Array& question);
  // Something that an overlay has started has ended.
  void Ended(std::int64_t wait, Json end);
  void TellEnds();

  sim::Simulation& simulation_;
  ServiceDirectory& directory_;
  std::vector<sim::OwnComponent*> components_;  // by robot, then as mounted
  std::map<const sim::OwnComponent*, bool> off_;
  std::unique_ptr<CodeHost> python_;
  std::unique_ptr<CodeHost> plugins_;
  std::vector<std::unique_ptr<Overlay>> overlays_;  // in the order of what they are on
  struct Pending {
    const void* of;  // component or overlay
    sim::Completion done;
  };
  std::map<std::int64_t, Pending> pending_;  // by ticket
  std::int64_t last_ticket_ = 0;
  // What overlays have started of their components, and its end once it has come.
  struct Wait {
    Overlay* overlay;
    std::int64_t callback;
    std::optional<Json> end = {};
  };
  std::map<std::int64_t, Wait> waits_;
  std::int64_t last_wait_ = 0;
  // For what is called when the simulation outlives this: nullptr then.
  std::shared_ptr<OwnComponents*> self_ = std::make_shared<OwnComponents*>(this);
  bool busy_ = false;  // own code runs
  std::vector<OwnTask> tasks_;
  std::vector<std::pair<OwnTask, OwnAnswer>> first_answers_;  // of their making
};

}  // namespace ccmorse::servers
