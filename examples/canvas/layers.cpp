// A robot that drives about and shows what it knows: grid maps in layers, as in figures 4.5 to 4.7
// of the thesis. Start `ccmorse run syrotek`, then this program:
//
//   g++ -std=c++17 layers.cpp -o layers -lCCMorse && ./layers [PORT [SECONDS]]
//
// It ends after SECONDS of simulated time, 60 if not given, and has the simulator save the canvas
// as layers.png.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "libCCMorse/CCMorse.h"

using namespace CCMorse;

namespace {

constexpr int kWidth = 172;       // cells
constexpr int kHeight = 186;      // cells
constexpr double kRobot = 0.098;  // m: the radius that obstacles are inflated by

constexpr std::size_t kCells = std::size_t{kWidth} * kHeight;

/// Where a cell stands in a list of all, row by row from the bottom.
std::size_t IndexOf(ImagePoint_t at) {
  return static_cast<std::size_t>(at.y) * kWidth + static_cast<std::size_t>(at.x);
}

/// What is known of each cell: 0 free, 0.5 unknown, 1 an obstacle.
class Map {
 public:
  Map() : cells_(kCells, 0.5) {}

  const std::vector<double>& cells() const { return cells_; }

  /// Takes a beam in: the cells on its way are rather free, the one at its end rather is not.
  void Add(ImagePoint_t from, ImagePoint_t to, bool hit) {
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    for (int i = 0; i < steps; ++i) {
      Change(from.x + (to.x - from.x) * i / steps, from.y + (to.y - from.y) * i / steps, -0.1);
    }
    if (hit) Change(to.x, to.y, 0.3);
  }

 private:
  void Change(int x, int y, double by) {
    if (x < 0 || x >= kWidth || y < 0 || y >= kHeight) return;
    double& cell = cells_[IndexOf({x, y})];
    cell = std::clamp(cell + by, 0.0, 1.0);
  }

  std::vector<double> cells_;
};

/// The shortest way through cells that are explored, free and not inflated, from cell to cell; the
/// first steps may leave an inflated place. Empty when there is none. By breadth first from the
/// goal.
std::vector<ImagePoint_t> FindPath(const Map& map, const GridMap& inflated, ImagePoint_t from,
                                   ImagePoint_t goal) {
  std::vector<int> steps(kCells, -1);
  std::vector<ImagePoint_t> front{goal};
  steps[IndexOf(goal)] = 0;
  const ImagePoint_t around[] = {{1, 0}, {0, 1},  {-1, 0},  {0, -1},
                                 {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (std::size_t next = 0; next < front.size() && steps[IndexOf(from)] < 0; ++next) {
    const ImagePoint_t at = front[next];
    for (const ImagePoint_t& way : around) {
      const ImagePoint_t to(at.x + way.x, at.y + way.y);
      if (to.x < 0 || to.x >= kWidth || to.y < 0 || to.y >= kHeight) continue;
      const bool near = std::abs(to.x - from.x) + std::abs(to.y - from.y) < 8;
      if (steps[IndexOf(to)] >= 0 || map.cells()[IndexOf(to)] > 0.2) continue;
      if (!near && inflated.GetPixel(to.x, to.y)) continue;
      steps[IndexOf(to)] = steps[IndexOf(at)] + 1;
      front.push_back(to);
    }
  }
  std::vector<ImagePoint_t> path;
  if (steps[IndexOf(from)] < 0) return path;
  for (ImagePoint_t at = from; steps[IndexOf(at)] > 0;) {
    path.push_back(at);
    for (const ImagePoint_t& way : around) {
      const ImagePoint_t to(at.x + way.x, at.y + way.y);
      if (to.x < 0 || to.x >= kWidth || to.y < 0 || to.y >= kHeight) continue;
      if (steps[IndexOf(to)] == steps[IndexOf(at)] - 1) {
        at = to;
        break;
      }
    }
  }
  path.push_back(goal);
  return path;
}

/// Goes on where there is more room; where something is near, turns on the spot, one way until it
/// is free again.
class Avoidance {
 public:
  void Drive(const LaserProxy& laser, Position2dProxy& position) {
    double left = laser.GetMaxRange();
    double right = left;
    for (std::uint32_t i = 0; i < laser.GetCount(); ++i) {
      const double bearing = laser.GetBearing(i);
      if (std::fabs(bearing) > 60 * PI / 180) continue;
      double& nearest = bearing > 0.0 ? left : right;
      nearest = std::min(nearest, laser.GetRange(i));
    }
    const double room = std::min(left, right);
    if (room > 0.25) turn_ = 0.0;
    if (room < 0.16 && turn_ == 0.0) turn_ = left > right ? 0.8 : -0.8;
    position.SetSpeed(turn_ == 0.0 ? 0.2 : 0.0, turn_ == 0.0 ? left - right : turn_);
  }

 private:
  double turn_ = 0.0;  // rad/s; 0 while there is room
};

}  // namespace

int main(int argc, char** argv) {
  try {
    PlayerClient client("localhost", argc > 1 ? std::atoi(argv[1]) : 4000);
    const double seconds = argc > 2 ? std::atof(argv[2]) : 60.0;
    Position2dProxy position(&client, 0);
    LaserProxy laser(&client, 0);
    WindowProxy& window = WindowProxy::GetInstance(&client, kWidth, kHeight);

    // From the lowest to the topmost: what is known, and on it what follows from it.
    GridMap& base = window.AddLayer("map");
    GridMap& inflated = window.AddLayer("inflated obstacles", LayerColor::kInflated, 1, 0.3);
    GridMap& scan = window.AddLayer("scan", LayerColor::kScan, 2, 0.5);
    GridMap& way_back = window.AddLayer("way back", LayerColor::kPath, 3);
    GridMap& trace = window.AddLayer("trace", LayerColor::kTrace, 4);

    Map map;
    Avoidance avoidance;
    position.SetMotorEnable(true);
    client.Read();
    const ImagePoint_t start(window.GetX(position.GetXPos()), window.GetY(position.GetYPos()));
    while (laser.GetDataTime() < seconds) {
      const player_pose2d_t robot{position.GetXPos(), position.GetYPos(), position.GetYaw()};
      const double mount = laser.GetPose().px;  // m before the robot's middle
      const double x = robot.px + mount * std::cos(robot.pa);
      const double y = robot.py + mount * std::sin(robot.pa);
      const ImagePoint_t from(window.GetX(x), window.GetY(y));
      for (std::uint32_t i = 0; i < laser.GetCount(); ++i) {
        const double angle = robot.pa + laser.GetBearing(i);
        const double range = laser.GetRange(i);
        map.Add(
            from,
            {window.GetX(x + range * std::cos(angle)), window.GetY(y + range * std::sin(angle))},
            range < laser.GetMaxRange());
      }
      const ImagePoint_t here(window.GetX(robot.px), window.GetY(robot.py));
      base.SetOccupancy(map.cells());
      inflated.SetInflated(base, kRobot);
      scan.SetScan(robot, laser);
      trace.AddToTrace(robot.px, robot.py);
      way_back.Clear();
      for (const ImagePoint_t& cell : FindPath(map, inflated, here, start)) {
        way_back.SetPixel(cell.x, cell.y);
      }
      avoidance.Drive(laser, position);
      client.Read();  // shows it all
    }
    position.SetSpeed(0.0, 0.0);
    window.SaveImageCopy("layers");
    delete &window;
    return 0;
  } catch (const MorseError& error) {
    std::fprintf(stderr, "layers: %s\n", error.GetErrorStr().c_str());
    return 1;
  }
}
