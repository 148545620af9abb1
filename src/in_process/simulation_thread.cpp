#include "in_process/simulation_thread.h"

#include <boost/asio/post.hpp>
#include <csignal>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "scene/player/import.h"
#include "scene/scenario.h"
#include "servers/run_report.h"

namespace ccmorse::in_process {
namespace {

// Threads that are made meanwhile take no signals: a program's handlers run in its own threads, and
// its calls are the ones that signals interrupt.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

servers::Pace PaceOf(const scene::Scenario& scenario) {
  if (scenario.time.strategy == "lockstep") return servers::Pace::kLockstep;
  if (scenario.time.strategy == "max") return servers::Pace::kMax;
  return servers::Pace::kRealTime;
}

}  // namespace

SimulationThread::SimulationThread(Options options) : options_(std::move(options)) {
  // Nothing is printed unless one of the simulations has asked for it.
  static const bool quiet = (SetLogLevel(LogLevel::kOff), true);
  if (quiet && options_.log) SetLogLevel(*options_.log);
  scene::ImportedScenario imported = scene::ImportScenario(scene::FindScenario(options_.scenario));
  for (const scene::FileNote& note : imported.notes) {
    if (note.matters) LogWarning("{}: {}", note.at.Text(), note.text);
  }
  scene::Scenario scenario = std::move(imported.scenario);
  if (options_.seed) scenario.seed = *options_.seed;

  servers::RunOptions run;
  run.pace = pace_ = options_.pace.value_or(PaceOf(scenario));
  run.factor = options_.factor.value_or(scenario.time.factor);
  run.seconds = options_.seconds > 0.0 ? options_.seconds : scenario.time.end;
  run.clients = options_.clients;
  run.morse.listen = false;
  run.player.emplace().listen = false;
  if (!options_.record.empty() && options_.record == options_.report) {
    throw Error("sim: record and report are files of their own, but both are called " +
                options_.record);
  }
  servers::PrepareFile(options_.record);
  servers::PrepareFile(options_.report);

  const SignalsBlocked blocked;
  simulation_.emplace(std::move(scenario), options_.threads);
  simulation_->canvas().set_picture_folder(options_.out);
  runner_.emplace(*simulation_, run);
  if (!options_.record.empty()) {
    runner_->AddWatcher(recorder_.emplace(*simulation_, options_.record, servers::RecordOptions{}));
  }
}

SimulationThread::~SimulationThread() {
  runner_->StopAtOnce();
  Join();
}

int SimulationThread::ConnectMorse() {
  const int client = runner_->morse().Connect();
  Start();
  return client;
}

int SimulationThread::ConnectPlayer(const std::string& robot) {
  const int client = runner_->player()->Connect(robot);
  Start();
  return client;
}

void SimulationThread::Finish() {
  boost::asio::post(runner_->io(), [this] { runner_->StopAfterClients(); });
  Join();
}

void SimulationThread::Start() {
  const std::lock_guard lock(mutex_);
  if (thread_.joinable()) return;
  const SignalsBlocked blocked;
  thread_ = std::thread([this] { Run(); });
}

void SimulationThread::Join() {
  const std::lock_guard lock(mutex_);
  if (thread_.joinable()) thread_.join();
}

void SimulationThread::Run() noexcept {
  try {
    const servers::RunSummary summary = runner_->Run();
    if (!options_.report.empty()) {
      servers::WriteReport(servers::ReportJson(*simulation_, runner_->morse(), summary, pace_),
                           options_.report);
    }
  } catch (const std::exception& error) {
    LogError("the simulation has ended: {}", error.what());
  }
  try {
    runner_->CloseServers();  // what clients wait for will not come
  } catch (const std::exception& error) {
    LogError("{}", error.what());
  }
}

}  // namespace ccmorse::in_process
