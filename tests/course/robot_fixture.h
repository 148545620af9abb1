#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "courses/par/intro/solutions/thesis/robot.h"
#include "imr-h/imr_config.h"
#include "imr-h/logging.h"

namespace course {

/// A world of the stand-in library for one test, with the program's output collected.
class RobotTest : public testing::Test {
 protected:
  RobotTest() : old_(std::cout.rdbuf(text_.rdbuf())) {
    CCMorse::World() = &world_;
    imr::setLogLevel(imr::LogLevel::kDebug);
    imr::robot::CRobot::getConfig(config_);
  }
  ~RobotTest() override {
    std::cout.rdbuf(old_);
    CCMorse::World() = nullptr;
  }

  /// Runs a robot from its first scan until its loop has ended by itself: a test must arrange the
  /// end, by world_.on_read or `seconds`. The robot is gone afterwards.
  void Drive(double seconds = 0.0) {
    imr::robot::CRobot robot(config_);
    robot.stopAfter(seconds);
    robot.execute();
    robot.join();
    alive_ = robot.isAlive();
    summary_ = robot.getSummary();
  }

  /// The recorded calls that begin with `prefix`.
  std::vector<std::string> Calls(const std::string& prefix) {
    std::vector<std::string> found;
    for (const std::string& call : world_.Calls()) {
      if (call.rfind(prefix, 0) == 0) found.push_back(call);
    }
    return found;
  }

  std::string Output() const { return text_.str(); }

  CCMorse::StubWorld world_;
  imr::CConfig config_;
  bool alive_ = false;
  imr::robot::SSummary summary_;

 private:
  std::ostringstream text_;
  std::streambuf* old_;
};

/// config.print() as one text.
inline std::string Dump(const imr::CConfig& config) {
  std::ostringstream out;
  config.print(out);
  return out.str();
}

}  // namespace course
