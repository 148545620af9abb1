#pragma once

#include <cstdint>
#include <map>
#include <memory>
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

/// Runs the components of one's own in a simulation, in lock-step with its ticks: sensors that are
/// due after all others have looked, actuators before all others act, services when they are
/// called. What their code does goes through the directory of services. A component whose code
/// raises, hangs or crashes is switched off, with a line in the log, and the simulation goes on.
/// Not thread safe.
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

  CodeHost& HostOf(const sim::OwnComponent& component);
  // Throws ServiceFailed for a component that is off, or a call from within its own code.
  OwnAnswer PerformOne(OwnTask task);
  void Perform(std::vector<OwnTask>& tasks);
  void Take(const OwnTask& task, const OwnAnswer& answer);
  void SwitchOff(sim::OwnComponent& component, const std::string& reason);
  // Whoever waits for one of its services is told that it failed.
  void EndServices(const sim::OwnComponent& component, const std::string& reason);
  Json Ask(const Json& question);

  sim::Simulation& simulation_;
  ServiceDirectory& directory_;
  std::vector<sim::OwnComponent*> components_;  // by robot, then as mounted
  std::map<const sim::OwnComponent*, bool> off_;
  std::unique_ptr<CodeHost> python_;
  std::unique_ptr<CodeHost> plugins_;
  struct Pending {
    sim::OwnComponent* component;
    sim::Completion done;
  };
  std::map<std::int64_t, Pending> pending_;  // by ticket
  std::int64_t last_ticket_ = 0;
  bool busy_ = false;  // own code runs
  std::vector<OwnTask> tasks_;
  std::vector<std::pair<OwnTask, OwnAnswer>> first_answers_;  // of their making
};

}  // namespace ccmorse::servers
