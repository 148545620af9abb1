// Programs beside us: what they print, how they end, and that none outlives its object.

#include "tools/child_process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>

#include <chrono>
#include <memory>

#include "base/error.h"

namespace ccmorse::tools {
namespace {

ChildProcess::Options Shell(const std::string& script) {
  return {{"/bin/sh", "-c", script}, "", {}};
}

FinishedProcess RunShell(const std::string& script) { return RunToEnd({"/bin/sh", "-c", script}); }

TEST(ChildProcess, OutputAndExitStatus) {
  const FinishedProcess ended = RunShell("echo out; echo err >&2; exit 3");
  EXPECT_EQ(ended.out, "out\n");
  EXPECT_EQ(ended.err, "err\n");
  EXPECT_EQ(ended.status.Text(), "exit status 3");
  EXPECT_FALSE(ended.status.ok());
  EXPECT_TRUE(RunShell("true").status.ok());
}

TEST(ChildProcess, ASignalIsNamed) {
  EXPECT_EQ(RunShell("kill -SEGV $$").status.Text(), "killed by SIGSEGV (Segmentation fault)");
  EXPECT_NE(RunShell("kill -40 $$").status.Text().find("killed by SIG"), std::string::npos);
}

TEST(ChildProcess, FolderEnvironmentAndAnEmptyStdin) {
  ChildProcess process(
      {{"/bin/sh", "-c", "pwd; echo $NEW $HOME; cat"}, "/usr", {"NEW=x", "HOME=y"}});
  std::string out;
  while (process.out() >= 0) {
    pollfd pipe{process.out(), POLLIN, 0};
    ::poll(&pipe, 1, 10000);
    process.ReadOut(out);
  }
  EXPECT_EQ(out, "/usr\nx y\n");
}

TEST(ChildProcess, WhatCannotBeStartedSaysWhy) {
  try {
    ChildProcess process({{"/no/such/program"}, "", {}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "cannot start /no/such/program: No such file or directory");
  }
  EXPECT_THROW(ChildProcess({{"/bin/sh"}, "/no/such/folder", {}}), Error);
}

// The pipe that every process of a group holds ends when the last of them has gone.
TEST(ChildProcess, WhatItLeavesBehindEndsWithIt) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(RunShell("sleep 1000 & echo started").out, "started\n");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(100));
}

TEST(ChildProcess, ItAndItsGroupEndWithTheObject) {
  auto process = std::make_unique<ChildProcess>(Shell("sleep 1000 & echo $!; wait"));
  std::string text;
  while (text.find('\n') == std::string::npos) {
    pollfd pipe{process->out(), POLLIN, 0};
    ::poll(&pipe, 1, 10000);
    process->ReadOut(text);
  }
  const pid_t sleeper = std::stoi(text);
  ASSERT_EQ(::kill(sleeper, 0), 0);
  process.reset();
  // Its new parent reaps it in its own time; until then it is a zombie, which is gone enough.
  for (int i = 0; i < 500 && ::kill(sleeper, 0) == 0; ++i) {
    const std::string stat = ReadFile("/proc/" + text.substr(0, text.size() - 1) + "/stat");
    if (stat.find(") Z ") != std::string::npos) break;
    ::poll(nullptr, 0, 10);
    ASSERT_LT(i, 499) << "it still runs";
  }
}

}  // namespace
}  // namespace ccmorse::tools
