// The program of the introduction task: reads the options, drives until it is told to end, and says
// what it has done.
//
// Exit status: 0 after a drive that ended as it should (by --seconds, Ctrl-C or the end of the
// simulation), 1 after an error of the connection or the robot, 2 for wrong options.

#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

#include "imr-h/args_config.h"
#include "imr-h/imr_exceptions.h"
#include "imr-h/logging.h"
#include "libCCMorse/MorseError.h"
#include "robot.h"

namespace {

std::atomic<bool> endRequested(false);  // lock-free, so that a signal's handler may write it

extern "C" void requestEnd(int) { endRequested = true; }

// From now on Ctrl-C ends the drive instead of the program; a second one ends the program at once.
void catchSignals() {
  struct sigaction action = {};
  action.sa_handler = requestEnd;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int drive(imr::CConfig& config) {
  imr::robot::CRobot robot(config);
  robot.stopAfter(config.get<double>("seconds"));
  catchSignals();
  robot.execute();
  while (robot.isRunning() && !endRequested) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  robot.stop();
  robot.join();

  const imr::robot::SSummary summary = robot.getSummary();
  INFO("Drove " << summary.distance << " m in " << summary.seconds << " s, " << summary.scans
                << " scans, nearest obstacle " << summary.nearest << " m");
  return robot.isAlive() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::robot::CRobot::getConfig(config);
  config.add<double>("seconds", "seconds to drive, by the time of the scans; 0: until Ctrl-C", 0.0);

  imr::SProgram program;
#ifdef _MORSE
  program.about = "Drives a simulated robot around and avoids obstacles by its laser.";
  program.examples = {"", "--seconds 60", "--coords --x 1.0 --y 2.0 --yaw 0"};
#else
  program.about = "Drives a real robot around and avoids obstacles by its laser.";
  program.examples = {"--host localhost --port 4000", "--position2d-index 2"};
#endif  // _MORSE

  try {
    if (!imr::parseArguments(argc, argv, config, program)) return 0;
    imr::assert_usage(config.get<double>("seconds") >= 0.0,
                      "option --seconds must not be negative");
  } catch (const imr::bad_usage& e) {
    std::cerr << e.what() << '\n';
    return 2;
  }

  try {
    return drive(config);
  } catch (CCMorse::MorseError& e) {
    ERROR("Morse error: " << e.GetErrorStr() << " function: " << e.GetErrorFun());
  } catch (const imr::exception& e) {
    ERROR("Imr error: " << e.what());
  }
  return 1;
}
