#include "grade/map_answer.h"

#include <cmath>

#include "base/error.h"
#include "base/json.h"

namespace ccmorse::grade {
namespace {

constexpr int kMostCells = 1 << 20;

double Number(const Json& value, const char* what) {
  if (!value.IsNumber() || !std::isfinite(value.AsDouble())) {
    throw Error(std::string(what) + " is no number");
  }
  return value.AsDouble();
}

Json Parse(const std::string& text) {
  try {
    return Json::Parse(text);
  } catch (const JsonError& error) {
    throw Error(std::string("it is no JSON: ") + error.what());
  }
}

int Count(const Json& map, const char* key) {
  const Json* const value = map.Find(key);
  if (value == nullptr || !value->IsInt() || value->AsInt() < 1 || value->AsInt() > kMostCells) {
    throw Error(std::string("'") + key + "' is no number of cells");
  }
  return static_cast<int>(value->AsInt());
}

// Of all set cells of `grid`, the share that has one of `others` within kTolerance cells.
double Matched(const Grid& grid, const Grid& others) {
  const Grid near = Grown(others, kTolerance);
  int all = 0;
  int matched = 0;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] == 0) continue;
    ++all;
    matched += near.cells[i] != 0 ? 1 : 0;
  }
  return all == 0 ? 0.0 : static_cast<double>(matched) / all;
}

}  // namespace

char MapAnswer::At(Vec2 point) const {
  const double x = std::floor((point.x - origin.x) / cell_size);
  const double y = std::floor((point.y - origin.y) / cell_size);
  if (!(x >= 0.0) || !(y >= 0.0) || !(x < width) || !(y < height)) return '?';
  return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x)];
}

MapAnswer ReadMap(const std::string& text) {
  const Json json = Parse(text);
  MapAnswer map;
  map.width = Count(json, "width");
  map.height = Count(json, "height");
  const Json* const cell_size = json.Find("cell_size");
  const Json* const origin = json.Find("origin");
  const Json* const cells = json.Find("cells");
  if (cell_size == nullptr || origin == nullptr || cells == nullptr || !cells->IsString() ||
      !origin->IsArray() || origin->AsArray().size() != 2) {
    throw Error("it lacks 'cell_size', 'origin' or 'cells'");
  }
  map.cell_size = Number(*cell_size, "'cell_size'");
  if (!(map.cell_size >= 1e-3)) throw Error("'cell_size' is no length of a cell, m");
  map.origin = {Number(origin->AsArray()[0], "'origin'"), Number(origin->AsArray()[1], "'origin'")};
  map.cells = cells->AsString();
  if (map.cells.size() !=
          static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height) ||
      map.cells.find_first_not_of("01?") != std::string::npos) {
    throw Error("'cells' has not width times height characters of 0, 1 and ?");
  }
  return map;
}

std::vector<Vec2> ReadPath(const std::string& text) {
  const Json json = Parse(text);
  if (!json.IsArray()) throw Error("it is no list of points");
  std::vector<Vec2> path;
  for (const Json& point : json.AsArray()) {
    if (!point.IsArray() || point.AsArray().size() != 2) throw Error("a point is not [x, y]");
    path.push_back(
        {Number(point.AsArray()[0], "x of a point"), Number(point.AsArray()[1], "y of a point")});
    constexpr double kFar = 1000.0;
    if (std::fabs(path.back().x) > kFar || std::fabs(path.back().y) > kFar) {
      throw Error("a point is more than 1000 m away");
    }
  }
  if (path.size() < 2) throw Error("it has fewer than two points");
  return path;
}

Pose2 ReadPose(const std::string& text) {
  const Json json = Parse(text);
  if (!json.IsArray() || json.AsArray().size() != 3) throw Error("it is not [x, y, yaw]");
  return {Number(json.AsArray()[0], "x"), Number(json.AsArray()[1], "y"),
          Number(json.AsArray()[2], "yaw")};
}

Grid ReachableFloor(const scene::World& world, Vec2 start) {
  const Grid walls = Walls(world, 0.0);
  const Grid room = Inverted(Grown(walls, kDilation));
  // A robot that touches a wall stands where the grid sees no room; then it is the nearest that
  // has.
  Cell from = CellOf(start);
  for (int reach = 1; reach <= kDilation && !room.Has(from); ++reach) {
    const Cell middle = CellOf(start);
    for (int dy = -reach; dy <= reach && !room.Has(from); ++dy) {
      for (int dx = -reach; dx <= reach && !room.Has(from); ++dx) {
        if (room.Has({middle.x + dx, middle.y + dy})) from = {middle.x + dx, middle.y + dy};
      }
    }
  }
  Grid floor = Grown(Connected(room, from), kDilation);
  for (std::size_t i = 0; i < floor.cells.size(); ++i) {
    if (walls.cells[i] != 0) floor.cells[i] = 0;
  }
  return floor;
}

MapScores CompareMap(const MapAnswer& map, const scene::World& world, const Grid& reachable,
                     const Grid& seen) {
  MapScores scores;
  const Grid walls = Walls(world, 0.0);
  const Grid near = Grown(seen, kTolerance);
  Grid said(walls.width, walls.height);
  Grid said_and_seen = said;
  int right = 0;
  for (int y = 0; y < walls.height; ++y) {
    for (int x = 0; x < walls.width; ++x) {
      const Cell at{x, y};
      const char cell = map.At(MiddleOf(at));
      if (cell == '1') said.Set(at);
      if (cell == '1' && near.Has(at)) said_and_seen.Set(at);
      right += cell == '0' && reachable.Has(at) && seen.Has(at) ? 1 : 0;
    }
  }
  const int all = reachable.Count();
  if (all > 0) scores.accuracy = static_cast<double>(right) / all;
  // Only surfaces can be seen: those that border on where the robot can come.
  Grid surfaces = Grown(reachable, kTolerance);
  for (std::size_t i = 0; i < surfaces.cells.size(); ++i) {
    if (walls.cells[i] == 0) surfaces.cells[i] = 0;
  }
  const double precision = Matched(said, walls);
  const double recall = Matched(surfaces, said_and_seen);
  if (precision > 0.0 && recall > 0.0) scores.iou = 1.0 / (1.0 / precision + 1.0 / recall - 1.0);
  return scores;
}

MapPicture PictureOf(const MapAnswer& map, const scene::World& world, const Grid& seen) {
  const Grid walls = Walls(world, 0.0);
  const Grid near_walls = Grown(walls, kTolerance);
  const Grid near_seen = Grown(seen, kTolerance);
  MapPicture picture{walls.width, walls.height, {}};
  picture.cells.reserve(walls.cells.size());
  for (int y = 0; y < walls.height; ++y) {
    for (int x = 0; x < walls.width; ++x) {
      const Cell at{x, y};
      const char cell = map.At(MiddleOf(at));
      MapPicture::Kind kind = MapPicture::kUnknown;
      if (cell != '?' && !near_seen.Has(at)) {
        kind = MapPicture::kNotSeen;
      } else if (cell == '1') {
        kind = near_walls.Has(at) ? MapPicture::kWall : MapPicture::kInventedWall;
      } else if (cell == '0') {
        kind = walls.Has(at) ? MapPicture::kMissedWall : MapPicture::kFree;
      }
      picture.cells.push_back(kind);
    }
  }
  return picture;
}

}  // namespace ccmorse::grade
