// `ccmorse batch --slurm` with a real Slurm on this machine: its controller, its node and MUNGE as
// children of the test, with a configuration and folders of their own, ended with it. It needs
// root, because Slurm's node daemon does, and Debian's slurm-wlm and munge; it is skipped without.

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "base/error.h"
#include "tests/support/process.h"

namespace ccmorse::testing {
namespace {

constexpr const char* kMunged = "/usr/sbin/munged";
constexpr const char* kController = "/usr/sbin/slurmctld";
constexpr const char* kNode = "/usr/sbin/slurmd";

int FreePort() {
  const int probe = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(probe, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
      ::getsockname(probe, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    throw std::runtime_error("no free port");
  }
  ::close(probe);
  return ntohs(address.sin_port);
}

// Runs `command` until its output has `text`; false when it never has.
bool WaitUntil(const std::vector<std::string>& command, const std::string& text, bool present) {
  for (int i = 0; i < 300; ++i) {
    const bool has = RunToEnd(command).output.find(text) != std::string::npos;
    if (has == present) return true;
    ::usleep(100000);
  }
  return false;
}

// A cluster of this machine alone.
class Cluster {
 public:
  Cluster() {
    const std::string folder = folder_.path();
    ::chmod(folder.c_str(), 0755);
    for (const char* name : {"/munge", "/state", "/spool"}) {
      std::filesystem::create_directory(folder + name);
      ::chmod((folder + name).c_str(), 0755);
    }
    // MUNGE takes no key that others may read.
    std::ofstream(folder + "/munge/key") << std::string(64, 'k') << folder;
    ::chmod((folder + "/munge/key").c_str(), 0600);
    WriteConfiguration();
    ::setenv("SLURM_CONF", (folder + "/slurm.conf").c_str(), 1);
    munge_.emplace(std::vector<std::string>{
        kMunged, "--foreground", "--force", "--key-file=" + folder + "/munge/key",
        "--socket=" + folder + "/munge/socket", "--pid-file=" + folder + "/munge/pid",
        "--log-file=" + folder + "/munge/log", "--seed-file=" + folder + "/munge/seed"});
    for (int i = 0; i < 300 && !std::filesystem::exists(folder + "/munge/socket"); ++i) {
      ::usleep(100000);
    }
    controller_.emplace(std::vector<std::string>{kController, "-D", "-f", folder + "/slurm.conf"});
    node_.emplace(std::vector<std::string>{kNode, "-D", "-f", folder + "/slurm.conf"});
    ready_ = WaitUntil({"sinfo", "-h", "-o", "%T"}, "idle", true);
  }
  // The node first, so that no job of its loses its controller; each is waited for.
  ~Cluster() {
    for (auto* daemon : {&node_, &controller_, &munge_}) {
      (*daemon)->Signal(SIGTERM);
      (*daemon)->Wait(std::chrono::seconds(20));
      daemon->reset();
    }
    ::unsetenv("SLURM_CONF");
  }
  Cluster(const Cluster&) = delete;
  Cluster& operator=(const Cluster&) = delete;

  bool ready() const { return ready_; }
  std::string Logs() const {
    std::string text;
    for (const char* name : {"/munge/log", "/controller.log", "/node.log"}) {
      if (std::filesystem::exists(folder_.path() + name)) text += ReadFile(folder_.path() + name);
    }
    return text;
  }

 private:
  void WriteConfiguration() {
    const std::string folder = folder_.path();
    char name[256] = {};
    ::gethostname(name, sizeof name - 1);
    std::string host = name;
    host = host.substr(0, host.find('.'));
    std::ofstream(folder + "/cgroup.conf") << "CgroupPlugin=cgroup/v1\nCgroupAutomount=no\n";
    std::ofstream(folder + "/slurm.conf")
        << "ClusterName=test\nSlurmctldHost=" << host << "(127.0.0.1)\n"
        << "SlurmUser=root\nSlurmdUser=root\nAuthType=auth/munge\nAuthInfo=socket=" << folder
        << "/munge/socket\nSlurmctldPort=" << FreePort() << "\nSlurmdPort=" << FreePort()
        << "\nSlurmctldPidFile=" << folder << "/controller.pid\nSlurmdPidFile=" << folder
        << "/node.pid\nStateSaveLocation=" << folder << "/state\nSlurmdSpoolDir=" << folder
        << "/spool\nSlurmctldLogFile=" << folder << "/controller.log\nSlurmdLogFile=" << folder
        << "/node.log\nMailProg=/bin/true\nProctrackType=proctrack/linuxproc\n"
        << "TaskPlugin=task/none\nMpiDefault=none\nJobAcctGatherType=jobacct_gather/none\n"
        << "AccountingStorageType=accounting_storage/none\nSelectType=select/cons_tres\n"
        << "SelectTypeParameters=CR_CPU\nSlurmdParameters=config_overrides\nReturnToService=2\n"
        << "NodeName=" << host << " NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN\n"
        << "PartitionName=main Nodes=" << host << " Default=YES MaxTime=INFINITE State=UP\n";
  }

  TemporaryFolder folder_;
  std::optional<Process> munge_;
  std::optional<Process> controller_;
  std::optional<Process> node_;
  bool ready_ = false;
};

std::string Manifest() {
  return R"({"seconds": 3, "scenarios": ["syrotek", "course_map"], "seeds": [1, 2, 3],
    "programs": [")" +
         BuiltProgram("intro") + R"("], "jobs": [
    {"name": "fails", "scenario": "syrotek", "program": "sh", "args": ["-c", "exit 4"]}]})";
}

// What `ccmorse batch` does with the manifest in `folder`.
Finished RunBatch(const std::string& folder, const std::vector<std::string>& options) {
  std::vector<std::string> command = {kCcmorse, "batch", folder + "/m.json", "--out",
                                      folder + "/r.jsonl"};
  command.insert(command.end(), options.begin(), options.end());
  return RunToEnd(command);
}

TEST(Slurm, AnArrayGivesTheSameFileAsOneMachine) {
  if (::geteuid() != 0) GTEST_SKIP() << "Slurm's node daemon needs root";
  for (const char* program : {kMunged, kController, kNode, "/usr/bin/sbatch"}) {
    if (!std::filesystem::exists(program)) GTEST_SKIP() << program << " is not installed";
  }
  const TemporaryFolder here;
  std::ofstream(here.path() + "/m.json") << Manifest();
  ASSERT_EQ(RunBatch(here.path(), {}).status, 0);
  const TemporaryFolder folder;
  std::ofstream(folder.path() + "/m.json") << Manifest();

  const Cluster cluster;
  ASSERT_TRUE(cluster.ready()) << cluster.Logs();
  const Finished submitted =
      RunBatch(folder.path(), {"--slurm", "--tasks", "3", "--sbatch=--time=10"});
  ASSERT_EQ(submitted.status, 0) << submitted.output;
  EXPECT_NE(submitted.output.find("3 tasks for 7 jobs"), std::string::npos) << submitted.output;
  ASSERT_TRUE(WaitUntil({"squeue", "-h"}, "ccmorse", false))
      << RunToEnd({"squeue"}).output << cluster.Logs();
  const Finished collected = RunBatch(folder.path(), {"--collect"});
  EXPECT_EQ(collected.status, 0) << collected.output << cluster.Logs();
  EXPECT_EQ(ReadFile(folder.path() + "/r.jsonl"), ReadFile(here.path() + "/r.jsonl"));

  // Lost parts are done again, and only they.
  std::filesystem::remove(folder.path() + "/r.jsonl");
  std::filesystem::remove(folder.path() + "/r.slurm/part-2-of-3.jsonl");
  const Finished again = RunBatch(folder.path(), {"--slurm", "--tasks", "3"});
  EXPECT_NE(again.output.find("1 task for 2 jobs"), std::string::npos) << again.output;
  ASSERT_TRUE(WaitUntil({"squeue", "-h"}, "ccmorse", false)) << cluster.Logs();
  EXPECT_EQ(RunBatch(folder.path(), {"--collect"}).status, 0);
  EXPECT_EQ(ReadFile(folder.path() + "/r.jsonl"), ReadFile(here.path() + "/r.jsonl"));
  EXPECT_NE(RunBatch(folder.path(), {"--slurm"}).output.find("all 7 jobs have results"),
            std::string::npos);

  // What sbatch has to say reaches the user.
  std::ofstream(folder.path() + "/m.json") << R"({"seconds": 1, "scenarios": ["docks"]})";
  std::filesystem::remove(folder.path() + "/r.jsonl");
  std::filesystem::remove_all(folder.path() + "/r.slurm");
  const Finished refused =
      RunBatch(folder.path(), {"--slurm", "--sbatch=--partition=no_such_partition"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.output.find("nvalid partition"), std::string::npos) << refused.output;
}

TEST(Slurm, ADryRunPrintsTheScriptAndWritesNothing) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() + "/m.json") << Manifest();
  const Finished run = RunBatch(folder.path(), {"--slurm", "--dry-run", "--tasks", "3", "-j", "2"});
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(run.output.starts_with("#!/bin/sh\n")) << run.output;
  EXPECT_NE(run.output.find("--task \"$SLURM_ARRAY_TASK_ID/3\" -j 2\n"), std::string::npos);
  EXPECT_NE(run.output.find("# sbatch --array=1-3 " + folder.path() + "/r.slurm/job.sh\n"),
            std::string::npos)
      << run.output;
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/r.slurm"));
}

TEST(Slurm, WithoutSlurmItSaysSo) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() + "/m.json") << Manifest();
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", "/bin/nowhere", 1);
  std::ofstream(folder.path() + "/m.json") << R"({"seconds": 1, "scenarios": ["docks"]})";
  const Finished run = RunBatch(folder.path(), {"--slurm"});
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.output.find("there is no sbatch"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace ccmorse::testing
