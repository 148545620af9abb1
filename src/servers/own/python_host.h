#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "servers/own/code_host.h"
#include "servers/own/python_process.h"
#include "sim/simulation.h"

namespace ccmorse::servers {

struct OwnOptions;

/// Runs the components that are written in Python, all in one process of their own
/// (python/morse/core/host.py). One that hangs or crashes the process costs the others only what
/// they kept beside their local_data: they are made anew in a new process.
class PythonHost : public CodeHost {
 public:
  using Asker = std::function<Json(const Json&)>;

  /// Makes `components` and then `overlays`, which it gives to `taker` one by one. `asker` answers
  /// what their code asks of others' services. Throws Error.
  PythonHost(sim::Simulation& simulation, std::vector<sim::OwnComponent*> components,
             std::vector<Overlay*> overlays, const OwnOptions& options, Asker asker,
             const Taker& taker);

  void Perform(std::span<const OwnTask> tasks, const Taker& taker) override;

 private:
  using Clock = PythonProcess::Clock;

  void Begin(const Taker& taker, bool anew);
  Json Scene(bool anew) const;
  Json Birth(const sim::OwnComponent& component, bool anew) const;
  Json Birth(const Overlay& overlay) const;
  bool BeginOne(const OwnTask& task, const Taker& taker, bool anew);
  Json TaskJson(const OwnTask& task) const;
  Json Poses(std::span<const OwnTask> tasks) const;
  // What is answered to one task; null: the process has hung or died over it.
  Json ReadAnswer(std::chrono::duration<double> limit, std::string* reason);
  std::string LastPlace(const OwnTask& task) const;
  // Whoever the task is for is not asked again.
  void Drop(const OwnTask& task);
  bool IsThere(const OwnTask& task) const;

  sim::Simulation& simulation_;
  std::vector<sim::OwnComponent*> components_;  // that are not off
  std::vector<Overlay*> overlays_;              // likewise
  std::string python_;
  std::string folder_;
  std::chrono::duration<double> limit_;
  std::chrono::duration<double> start_limit_;
  Asker asker_;
  std::unique_ptr<PythonProcess> process_;
  std::map<const sim::OwnComponent*, std::string> places_;  // "FILE:LINE: " of default actions
};

}  // namespace ccmorse::servers
