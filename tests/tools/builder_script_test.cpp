// MORSE's builder scripts run in a python3 of their own, which can do no harm (specs: morse.md C).

#include "tools/builder_script.h"

#include <gtest/gtest.h>

#include <chrono>

#include "base/error.h"
#include "tests/support/process.h"

namespace ccmorse::tools {
namespace {

using ccmorse::testing::TemporaryFile;

std::string ErrorOf(const std::string& text, const ScriptOptions& options = {}) {
  const TemporaryFile script(".py", text);
  try {
    SceneFromScript(script.path(), options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool Has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(BuilderScript, MakesAScenarioAndNotes) {
  const TemporaryFile script(".py", R"(from morse.builder import *
robot = ATRV()
robot.translate(-3, 1)
pose = Pose()
robot.append(pose)
joystick = Joystick()
robot.append(joystick)
env = Environment('empty')
)");
  const scene::ImportedScenario made = SceneFromScript(script.path());
  ASSERT_EQ(made.scenario.robots.size(), 1U);
  const scene::RobotDef& robot = made.scenario.robots[0];
  EXPECT_EQ(robot.name, "robot");
  EXPECT_EQ(robot.pose.x, -3.0);
  ASSERT_TRUE(robot.components);
  ASSERT_EQ(robot.components->size(), 1U);
  EXPECT_EQ((*robot.components)[0].type, "Pose");
  EXPECT_FALSE((*robot.components)[0].stream);
  ASSERT_EQ(made.notes.size(), 1U);
  EXPECT_EQ(made.notes[0].at.line, 6);
  EXPECT_EQ(made.notes[0].at.file, script.path());
  EXPECT_EQ(made.notes[0].text, "robot.joystick: the component Joystick is not simulated yet");
  EXPECT_NEAR(made.scenario.world.low.x, -20.0, 1e-4);  // a float of the model file
}

TEST(BuilderScript, ArgumentsAndEnvironmentReachIt) {
  const TemporaryFile script(".py", R"(import os, sys
from morse.builder import *
assert sys.argv[1:] == ['--', 'one', '--two'], sys.argv
assert os.environ['MORSE_NODE'] == 'here'
env = Environment('empty')
)");
  ScriptOptions options;
  options.arguments = {"one", "--two"};
  options.environment = {"MORSE_NODE=here"};
  EXPECT_TRUE(SceneFromScript(script.path(), options).scenario.robots.empty());
}

TEST(BuilderScript, OneThatDoesNotEndIsEnded) {
  ScriptOptions options;
  options.time_limit = 1.0;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(Has(ErrorOf("while True: pass\n", options), "has not ended after 1 s"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(BuilderScript, WhatItLeavesRunningKeepsNobodyWaiting) {
  ScriptOptions options;
  options.time_limit = 30.0;
  const TemporaryFile script(".py", R"(import os, time
from morse.builder import *
env = Environment('empty')
if os.fork() == 0:
    os.close(1)  # the tests' own output, whose reader would wait for it; the scene's pipe stays open
    os.close(2)
    time.sleep(60)
    os._exit(0)
)");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NO_THROW(SceneFromScript(script.path(), options));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(BuilderScript, FailuresSayHowItEnded) {
  EXPECT_TRUE(Has(ErrorOf("import sys; sys.exit(3)\n"), "makes no scene: exit status 3"));
  EXPECT_TRUE(Has(ErrorOf("import os; os.abort()\n"), "SIGABRT"));
  EXPECT_TRUE(Has(ErrorOf("import os; os._exit(0)\n"), "makes no scene"));
  EXPECT_TRUE(Has(ErrorOf("raise ValueError('no')\n"), "exit status 1"));
  EXPECT_THROW(SceneFromScript("/nowhere/x.py"), Error);
}

TEST(BuilderScript, ASceneThatCannotBeNamesTheScriptAndTheRobots) {
  const std::string error = ErrorOf(R"(from morse.builder import *
a = ATRV()
b = ATRV()
env = Environment('empty')
)");
  EXPECT_TRUE(Has(error, "robot 'b' at (0, 0) overlaps robot 'a'")) << error;
  EXPECT_FALSE(Has(error, ".py:1:")) << error;
}

TEST(BuilderScript, IsToldByItsName) {
  EXPECT_TRUE(IsBuilderScript("some/scene.py"));
  EXPECT_FALSE(IsBuilderScript("some/scene.json"));
  const TemporaryFile script("", "from morse.builder import *\n");
  EXPECT_TRUE(IsBuilderScript(script.path()));
  const TemporaryFile json("", "  {\"seed\": 1}\n");
  EXPECT_FALSE(IsBuilderScript(json.path()));
}

}  // namespace
}  // namespace ccmorse::tools
