// The program of the exploration task: one thread gathers data and drives, one plans, until all is
// explored.
//
// Exit status: 0 when the run ended as it should, 1 after an error of the connection, 2 for wrong
// options.

#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

#include "control.h"
#include "exploration.h"
#include "imr-h/args_config.h"
#include "imr-h/imr_exceptions.h"
#include "imr-h/logging.h"
#include "libCCMorse/MorseError.h"

namespace {

std::atomic<bool> endRequested(false);  // lock-free, so that a signal's handler may write it

extern "C" void requestEnd(int) { endRequested = true; }

// The arena, as the planning task's map has it.
constexpr int WIDTH = 171;
constexpr int HEIGHT = 186;

int explore(const imr::CConfig& config) {
  imr::CMapGrid map(WIDTH, HEIGHT, imr::MAP_CELL_SIZE);
  imr::CControl control(config, map);
  imr::CExploration exploration(control);
  std::signal(SIGINT, requestEnd);
  std::signal(SIGTERM, requestEnd);
  exploration.execute();
  control.execute();
  while (control.isRunning() && !endRequested) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  control.stop();
  control.join();
  exploration.join();

  int known = 0;
  for (const double cell : map.cells()) known += cell != imr::CMapGrid::UNKNOWN ? 1 : 0;
  INFO((control.isExplored() ? "Explored: " : "Ended: ")
       << known << " of " << map.cells().size() << " cells known after " << control.getSeconds()
       << " s");
  const std::string file = config.get<std::string>("map");
  if (!file.empty()) map.save(file);
  return control.isAlive() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::SProgram program;
  program.about = "Explores the arena and makes a map of it.";
  program.examples = {"", "--map explored.yaml --seconds 120"};
  try {
    imr::CControl::getConfig(config);
    config.add<std::string>("map", "write the map here at the end, .txt or .yaml", "");
    if (!imr::parseArguments(argc, argv, config, program)) return 0;
  } catch (const imr::bad_usage& e) {
    std::cerr << e.what() << '\n';
    return 2;
  }
  try {
    return explore(config);
  } catch (CCMorse::MorseError& e) {
    ERROR("Morse error: " << e.GetErrorStr() << " function: " << e.GetErrorFun());
  } catch (const imr::exception& e) {
    ERROR("Imr error: " << e.what());
  }
  return 1;
}
