#pragma once

// The frame of a program whose task is one function: what is sensed comes in, a speed goes out. For
// both platforms: without _MORSE nothing is drawn nor handed in. Ours, for the course's first task
// and those in courses/syrotek; the course's own programs are the thesis's CRobot (thesis C.2).

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "imr-h/args_config.h"
#include "imr-h/imr_config.h"
#include "imr-h/imr_exceptions.h"
#include "imr-h/logging.h"
#include "libCCMorse/MorseError.h"
#ifdef _MORSE
#include "imr-h/canvas.h"
#include "libCCMorse/CCMorse.h"
#else
#include "libPlayer/LaserProxy.h"
#include "libPlayer/PlayerClient.h"
#include "libPlayer/Position2dProxy.h"
#endif

namespace imr {

/// Where a robot is: m, and rad counter-clockwise from the x axis.
struct SPose {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
};

/// A point in the plane, m.
struct SPoint {
  double x = 0.0;
  double y = 0.0;
};

/// What the motors are told: m/s forward, and rad/s counter-clockwise.
struct SSpeed {
  double v = 0.0;
  double w = 0.0;
};

/// What the laser has seen: beams from the right to the left.
struct SScan {
  double minAngle = 0.0;       ///< bearing of beam 0, rad counter-clockwise from straight ahead
  double resolution = 0.0;     ///< rad from beam to beam
  double maxRange = 0.0;       ///< m; a beam that hits nothing has it
  double mount = 0.0;          ///< m, how far the laser sits before the robot's middle
  std::vector<double> ranges;  ///< m

  /// Where a beam points, rad.
  double bearing(std::size_t i) const { return minAngle + static_cast<double>(i) * resolution; }
  /// What a beam has hit, as seen from the robot's middle: x forward, y to the left.
  SPoint point(std::size_t i) const {
    return {mount + ranges[i] * std::cos(bearing(i)), ranges[i] * std::sin(bearing(i))};
  }
  /// The beam with the smallest range between two bearings; ranges.size() where there is none.
  std::size_t nearest(double from, double to) const {
    std::size_t best = ranges.size();
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      if (bearing(i) < from || bearing(i) > to) continue;
      if (best == ranges.size() || ranges[i] < ranges[best]) best = i;
    }
    return best;
  }
  /// Its range, m; maxRange where there is none.
  double nearestRange(double from, double to) const {
    const std::size_t i = nearest(from, to);
    return i == ranges.size() ? maxRange : ranges[i];
  }
};

/// What a robot senses at one moment.
struct SSenses {
  double time = 0.0;   ///< s since the first scan, by the scans' own time
  double since = 0.0;  ///< s since the scan before; 0 at the first
  SPose pose;          ///< as position2d has it at the index that the option names
  SScan scan;
};

/// What a program draws over the arena, in m: layers of one colour, the first at the bottom. The
/// real robot has no canvas: there nothing happens.
class CSketch {
 public:
  /// A layer and its colour, 0..255 each.
  struct SInk {
    const char* layer;
    int red, green, blue;
    bool top = false;  ///< above all that are not
  };

#ifdef _MORSE
  explicit CSketch(CCanvas& to) : canvas(&to) {}
  void line(const SInk& ink, SPoint from, SPoint to) {
    CCMorse::WindowProxy& window = canvas->window();
    layerOf(ink).SetLine(window.GetX(from.x), window.GetY(from.y), window.GetX(to.x),
                         window.GetY(to.y), ink.red, ink.green, ink.blue);
  }
  void clear(const SInk& ink) { layerOf(ink).Clear(); }

 private:
  CCMorse::GridMap& layerOf(const SInk& ink) {
    CCMorse::WindowProxy& window = canvas->window();
    if (window.HasLayer(ink.layer)) return window.GetLayer(ink.layer);
    const auto part = [](int value) { return static_cast<unsigned char>(value); };
    return window.AddLayer(ink.layer, {part(ink.red), part(ink.green), part(ink.blue)},
                           next++ + (ink.top ? 1000 : 0), 0);
  }
  CCanvas* canvas;
  int next = 0;
#else
  void line(const SInk&, SPoint, SPoint) {}
  void clear(const SInk&) {}
#endif
};

/// What a student writes: the behaviour of one robot. One thread.
class CBehaviour {
 public:
  virtual ~CBehaviour() = default;
  /// The speed that answers what is sensed; called for each scan.
  virtual SSpeed step(const SSenses& senses, CSketch& sketch) = 0;
  /// Whether the task is done. The robot then stops; the program ends when all are done.
  virtual bool done() const { return false; }
  /// Where the robot takes itself to be, for tasks that ask for it: handed in at the end and drawn
  /// instead of where it is. Null: not asked.
  virtual const SPose* estimate() const { return nullptr; }
};

/// Connects to one robot for each behaviour, and drives until all are done, the time is over, the
/// simulation ends or Ctrl-C.
///
/// Its indexes are 0 (laser), --wheels-index (what takes speeds) and --position2d-index (what tells
/// the pose); in the simulator those of robot k are 10 k more, while real robots are a server each,
/// robot k's at --port + k. On SyRoTek's robots the base is position2d:0,
/// and position2d:2 the overhead camera, which drives nothing (specs: syrotek.md A). It draws the
/// way of each in green, and the position itself in magenta (thesis, Fig. 4.8).
class CRobotProgram {
 public:
  using Behaviours = std::vector<std::unique_ptr<CBehaviour>>;

  /// Adds the options that every such program has to `config`. `position2d`: index of the pose.
  static void addOptions(CConfig& config, int position2d = 2) {
#ifdef _MORSE
    config.add<std::string>("host", "morse server hostname", "localhost");
    config.add<int>("port", "morse server port", 4000);
    config.add<std::string>("save", "have the simulator save the canvas as this .png at the end",
                            "");
#else
    config.add<std::string>("host", "syrotek server hostname", "syrotek.felk.cvut.cz");
    config.add<int>("port", "syrotek server port; the next robot's is the next one", 38000);
#endif  // _MORSE
    config.add<int>("position2d-index", "position2d index of the pose", position2d);
    config.add<int>("wheels-index", "position2d index of what takes speeds", 0);
    config.add<double>("seconds", "seconds to drive, by the time of the scans; 0: until Ctrl-C",
                       0.0);
  }

  /// main() of such a program: reads the options, which `config` holds, and drives.
  /// @param make Makes the behaviours when the options have been read.
  /// @return 0 when it ended as it should, 1 after an error of the connection, 2 for wrong options.
  template <class Make>
  static int main(int argc, char** argv, CConfig& config, const SProgram& about, Make make) {
    try {
      if (!parseArguments(argc, argv, config, about)) return 0;
      assert_usage(config.get<double>("seconds") >= 0.0, "option --seconds must not be negative");
    } catch (const bad_usage& e) {
      std::cerr << e.what() << '\n';
      return 2;
    }
    try {
      CRobotProgram program(config, make());
      program.run();
      return 0;
    } catch (CCMorse::MorseError& e) {
      ERROR("Morse error: " << e.GetErrorStr() << " function: " << e.GetErrorFun());
    } catch (const imr::exception& e) {
      ERROR("Imr error: " << e.what());
    }
    return 1;
  }

  /// Connects. Throws CCMorse::MorseError if there is no server or no such device.
  CRobotProgram(const CConfig& config, Behaviours behaviours) : cfg(config) {
    assert_argument(!behaviours.empty(), "there is no robot to drive");
    const int index = cfg.get<int>("position2d-index");
    const int wheels = cfg.get<int>("wheels-index");
    assert_argument(index >= 0, "option --position2d-index must not be negative");
    assert_argument(wheels >= 0, "option --wheels-index must not be negative");
    for (std::size_t k = 0; k < behaviours.size(); ++k) {
#ifdef _MORSE
      const unsigned first = static_cast<unsigned>(10 * k);
#else
      const unsigned first = 0;
#endif  // _MORSE
      if (first == 0) {
        clients.push_back(std::make_unique<CCMorse::PlayerClient>(
            cfg.get<std::string>("host"), cfg.get<int>("port") + static_cast<int>(k)));
      }
      CCMorse::PlayerClient* const client = clients.back().get();
      SRobot robot;
      robot.behaviour = std::move(behaviours[k]);
      robot.laser = std::make_unique<CCMorse::LaserProxy>(client, first);
      robot.position =
          std::make_shared<CCMorse::Position2dProxy>(client, first + static_cast<unsigned>(index));
      robot.wheels = robot.position;
      if (wheels != index) {
        robot.wheels = std::make_shared<CCMorse::Position2dProxy>(
            client, first + static_cast<unsigned>(wheels));
      }
      robots.push_back(std::move(robot));
    }
#ifdef _MORSE
    // One cell is 2 cm of the arena.
    canvas = std::make_unique<CCanvas>(clients.front().get(), 172, 186);
    sketch = std::make_unique<CSketch>(*canvas);
#else
    sketch = std::make_unique<CSketch>();
#endif  // _MORSE
  }

  /// Drives. Throws CCMorse::MorseError when the connection breaks; the end of the simulation is
  /// none.
  void run() {
    std::signal(SIGINT, requestEnd);
    std::signal(SIGTERM, requestEnd);
    try {
      loop();
      finish();
    } catch (CCMorse::MorseError& e) {
#ifdef _MORSE
      if (e.SimulationEnded()) {
        INFO("The simulation has ended.");
        return;
      }
#endif  // _MORSE
      throw;
    }
  }

 private:
  struct SRobot {
    std::unique_ptr<CBehaviour> behaviour;
    std::unique_ptr<CCMorse::LaserProxy> laser;
    std::shared_ptr<CCMorse::Position2dProxy> position;  // tells where it is
    std::shared_ptr<CCMorse::Position2dProxy> wheels;    // takes speeds; may be the same
    SPoint last;                                         // where its line has come to
    double way = 0.0;                                    // m
    double first = 0.0;                                  // time of the first scan, s
    double time = -1.0;  // of the last scan since then, s; negative before the first
  };

  static std::atomic<bool>& ended() {
    static std::atomic<bool> value(false);  // lock-free, so that a signal's handler may write it
    return value;
  }
  static void requestEnd(int) { ended() = true; }

  static constexpr CSketch::SInk TRACE = {"way", 0, 255, 0};
  static constexpr CSketch::SInk HERE = {"position", 255, 0, 255, true};

  void loop() {
    const double limit = cfg.get<double>("seconds");
    for (const SRobot& robot : robots) robot.wheels->SetMotorEnable(true);
    for (bool over = false; !over;) {
      // All that has arrived: Read() waits for news, and so sets the pace of this loop.
      for (const auto& client : clients) {
        client->Read();
#ifdef _MORSE
        // Player's server sends the newest when asked; Peek() would ask before the command is out.
        while (client->Peek(0)) client->Read();
#endif  // _MORSE
      }
      bool moved = false;
      over = true;
      for (SRobot& robot : robots) {
        if (robot.laser->IsFresh() && robot.laser->IsValid() && robot.position->IsValid()) {
          if (!moved) sketch->clear(HERE);
          moved = true;
          step(robot);
        }
        // Half a millisecond less: times are sums of ticks, and may fall short by a rounding.
        const bool late = limit > 0.0 && robot.time >= limit - 0.0005;
        over = over && (late || robot.behaviour->done());
      }
      over = over || ended();
    }
  }

  void step(SRobot& robot) {
    robot.laser->NotFresh();
    SSenses senses;
    const double now = robot.laser->GetDataTime();
    if (robot.time < 0.0) robot.first = now;
    senses.time = now - robot.first;
    senses.since = robot.time < 0.0 ? 0.0 : senses.time - robot.time;
    senses.pose = {robot.position->GetXPos(), robot.position->GetYPos(), robot.position->GetYaw()};
    senses.scan.minAngle = robot.laser->GetMinAngle();
    senses.scan.resolution = robot.laser->GetScanRes();
    senses.scan.maxRange = robot.laser->GetMaxRange();
    senses.scan.mount = robot.laser->GetPose().px;
    senses.scan.ranges.resize(robot.laser->GetCount());
    for (unsigned i = 0; i < robot.laser->GetCount(); ++i) {
      senses.scan.ranges[i] = robot.laser->GetRange(i);
    }
    SSpeed speed;
    if (!robot.behaviour->done()) speed = robot.behaviour->step(senses, *sketch);
    if (robot.behaviour->done()) speed = {};
    robot.wheels->SetSpeed(speed.v, speed.w);

    const SPose* estimate = robot.behaviour->estimate();
    const SPose& shown = estimate != nullptr ? *estimate : senses.pose;
    const SPoint at = {shown.x, shown.y};
    if (robot.time < 0.0) robot.last = at;
    robot.way += std::hypot(at.x - robot.last.x, at.y - robot.last.y);
    sketch->line(TRACE, robot.last, at);
    sketch->line(HERE, at, at);
    robot.last = at;
    robot.time = senses.time;
  }

  // Stops the robots, and hands in what the task asks for.
  void finish() {
    for (const SRobot& robot : robots) {
      robot.wheels->SetSpeed(0.0, 0.0);
      INFO("Drove " << robot.way << " m in " << std::max(0.0, robot.time) << " s");
    }
    // Takes the commands along, and shows what was drawn last.
    for (const auto& client : clients) client->Read();
#ifdef _MORSE
    for (const SRobot& robot : robots) {
      const SPose* estimate = robot.behaviour->estimate();
      if (estimate != nullptr) handIn(*estimate);
    }
    const std::string picture = cfg.get<std::string>("save");
    if (!picture.empty()) canvas->save(picture);
#endif  // _MORSE
  }

#ifdef _MORSE
  // To the judge, if there is one (docs/grading.md); MORSE has none.
  static void handIn(const SPose& pose) {
    const std::vector<CCMorse::MorseRobot*>& all = CCMorse::MorseClient::GetInstance().GetRobots();
    CCMorse::MorseAnswers* answers =
        all.empty() ? nullptr : all[0]->FindDevice<CCMorse::MorseAnswers>();
    if (answers != nullptr) answers->SubmitPose(pose.x, pose.y, pose.yaw);
  }
#endif  // _MORSE

  const CConfig& cfg;
  std::vector<std::unique_ptr<CCMorse::PlayerClient>> clients;
  std::vector<SRobot> robots;
#ifdef _MORSE
  std::unique_ptr<CCanvas> canvas;
#endif
  std::unique_ptr<CSketch> sketch;
};

}  // namespace imr
