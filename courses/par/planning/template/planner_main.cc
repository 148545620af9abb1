// The program of the planning task: reads a map, plans a path in it, and shows it.
//
// Exit status: 0 when a path was found (and driven, with --drive), 1 when there is none or after an
// error of the connection, 2 for wrong options.

#include <chrono>
#include <cmath>
#include <iostream>

#include "imr-h/args_config.h"
#include "imr-h/imr_exceptions.h"
#include "imr-h/logging.h"
#include "libCCMorse/MorseError.h"
#include "planner.h"
#ifdef _MORSE
#include "imr-h/canvas.h"
#include "libCCMorse/CCMorse.h"
#include "libCCMorse/SndDriver.h"
#else
#include "libPlayer/PlayerClient.h"
#include "libPlayer/Position2dProxy.h"
#endif

namespace {

void addOptions(imr::CConfig& config) {
#ifdef _MORSE
  config.add<std::string>("host", "morse server hostname", "localhost");
  config.add<int>("port", "morse server port", 4000);
  config.add<std::string>("save", "have the simulator save the canvas as this .png", "");
#else
  config.add<std::string>("host", "syrotek server hostname", "syrotek.felk.cvut.cz");
  config.add<int>("port", "syrotek server port", 38000);
#endif  // _MORSE
  config.add<std::string>("map", "map file: .txt, .yaml, .pgm or .png", "../maps/arena.txt");
  config.add<int>("start-x", "column of the start, from the left", 26);
  config.add<int>("start-y", "row of the start, from the bottom", 172);
  config.add<int>("goal-x", "column of the goal", 160);
  config.add<int>("goal-y", "row of the goal", 10);
  config.add<bool>("drive", "drive along the smoothed path from where the robot is", false);
  config.add<bool>("offline", "plan without any server: nothing is shown nor driven", false);
}

#ifdef _MORSE
void drawPath(imr::CCanvas& canvas, const std::vector<imr::SCell>& cells, imr::CCanvas::Color color,
              const std::string& layer) {
  for (std::size_t i = 1; i < cells.size(); ++i) {
    canvas.drawLine(cells[i - 1].x, cells[i - 1].y, cells[i].x, cells[i].y, color, layer);
  }
}

// What figure 4.9 shows: the map, light blue where it is dilated, the path found in dark blue and
// the smoothed one in orange.
void draw(imr::CCanvas& canvas, const imr::CMapGrid& map, const imr::CPlanner& planner) {
  canvas.draw(map);
  for (int y = 0; y < map.getHeight(); ++y) {
    for (int x = 0; x < map.getWidth(); ++x) {
      if (map.getCell(x, y) == imr::CMapGrid::FLOOR && !planner.isFree(x, y)) {
        canvas.drawPixel(x, y, imr::CCanvas::LightBlue, "dilated");
      }
    }
  }
  drawPath(canvas, planner.getPath(), imr::CCanvas::DarkBlue, "path");
  drawPath(canvas, planner.getSmoothPath(), imr::CCanvas::Orange, "smoothed path");
}

// Hands the path in, for `ccmorse grade`: the smoothed one, or the one found as long as there is no
// other. Simulators that do not grade have nobody to hand it to.
void submit(CCMorse::PlayerClient& client, const imr::CMapGrid& map, const imr::CPlanner& planner) {
  const bool smoothed = planner.getSmoothPath().size() > 1;
  std::vector<player_point_2d_t> points;
  for (const imr::SCell& cell : smoothed ? planner.getSmoothPath() : planner.getPath()) {
    points.push_back({map.getPosX(cell.x), map.getPosY(cell.y)});
  }
  for (const CCMorse::MorseRobot* robot : client.GetMorseClient().GetRobots()) {
    auto* const answers = robot->FindDevice<CCMorse::MorseAnswers>();
    if (answers == nullptr) continue;
    answers->SubmitPath(points);
    return;
  }
}
#endif  // _MORSE

constexpr double PATIENCE = 60.0;  // s to the next corner

#ifdef _MORSE
// The driver runs within this program.
class CSnd {
 public:
  explicit CSnd(CCMorse::PlayerClient& client) : snd(&client) { snd.Start(); }
  bool reach(double x, double y, double yaw) {
    snd.GoTo(x, y, yaw);
    return snd.WaitForArrival(PATIENCE);
  }

 private:
  CCMorse::SndDriver snd;
};
#else
// The driver runs in the robot's server, as position2d:1; position2d:2 is the overhead camera.
class CSnd {
 public:
  explicit CSnd(CCMorse::PlayerClient& to) : client(to), snd(&to, 1), camera(&to, 2) {
    snd.SetMotorEnable(true);
  }
  bool reach(double x, double y, double yaw) {
    constexpr double NEAR = 0.1;  // m
    snd.GoTo(x, y, yaw);
    double begin = -1.0;
    for (;;) {
      client.Read();
      if (!camera.IsFresh()) continue;
      camera.NotFresh();
      if (begin < 0.0) begin = camera.GetDataTime();
      if (std::hypot(camera.GetXPos() - x, camera.GetYPos() - y) < NEAR) return true;
      if (camera.GetDataTime() - begin > PATIENCE) return false;
    }
  }

 private:
  CCMorse::PlayerClient& client;
  CCMorse::Position2dProxy snd;
  CCMorse::Position2dProxy camera;
};
#endif  // _MORSE

// Drives from corner to corner with the SND driver, which keeps clear of what the laser sees.
bool drive(CCMorse::PlayerClient& client, const imr::CMapGrid& map, const imr::CPlanner& planner) {
  CSnd snd(client);
  const std::vector<imr::SCell>& path = planner.getSmoothPath();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double yaw = std::atan2(path[i].y - path[i - 1].y, path[i].x - path[i - 1].x);
    if (!snd.reach(map.getPosX(path[i].x), map.getPosY(path[i].y), yaw)) {
      WARN("The robot did not reach corner " << i << " of " << path.size() - 1);
      return false;
    }
  }
  INFO("The robot is at the goal.");
  return true;
}

int run(const imr::CConfig& config) {
  const imr::CMapGrid map(config.get<std::string>("map"));
  imr::CPlanner planner;
  const auto begin = std::chrono::steady_clock::now();
  planner.setMap(map);
  const bool found = planner.plan(config.get<int>("start-x"), config.get<int>("start-y"),
                                  config.get<int>("goal-x"), config.get<int>("goal-y"));
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  const double metres = map.getCellSize();
  if (found) {
    INFO("Planned in " << took.count() << " ms: path "
                       << imr::CPlanner::lengthOf(planner.getPath()) * metres << " m, smoothed "
                       << imr::CPlanner::lengthOf(planner.getSmoothPath()) * metres << " m");
  } else {
    WARN("There is no path.");
  }
  if (config.get<bool>("offline")) return found ? 0 : 1;

  CCMorse::PlayerClient client(config.get<std::string>("host"), config.get<int>("port"));
  bool done = found;
#ifdef _MORSE
  imr::CCanvas canvas(&client, map.getWidth(), map.getHeight());
  draw(canvas, map, planner);
  client.Read();  // shows it
  if (found) submit(client, map, planner);
  const std::string picture = config.get<std::string>("save");
  if (!picture.empty()) canvas.save(picture);
#endif  // _MORSE
  if (found && config.get<bool>("drive")) done = drive(client, map, planner);
  return done ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::SProgram program;
  program.about = "Plans a path in a grid map and shows it.";
  program.examples = {"", "--start-x 26 --start-y 172 --goal-x 160 --goal-y 10", "--offline"};
  try {
    addOptions(config);
    if (!imr::parseArguments(argc, argv, config, program)) return 0;
  } catch (const imr::bad_usage& e) {
    std::cerr << e.what() << '\n';
    return 2;
  }
  try {
    return run(config);
  } catch (CCMorse::MorseError& e) {
    ERROR("Morse error: " << e.GetErrorStr() << " function: " << e.GetErrorFun());
  } catch (const imr::exception& e) {
    ERROR("Imr error: " << e.what());
  }
  return 1;
}
