#include "servers/player/devices/map_device.h"

#include <algorithm>
#include <cmath>

#include "base/polygon.h"
#include "wire/player/deflate.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr double kCell = 0.02;              // m
constexpr double kMostCells = 2048.0;       // each way
constexpr std::uint32_t kMostOfTile = 640;  // cells each way

}  // namespace

navigation::OccupancyGrid DrawWorld(const sim::World& world) {
  const scene::World& scene = world.scene();
  const double scale = std::max({kCell, scene.size_x / kMostCells, scene.size_y / kMostCells});
  navigation::OccupancyGrid map(static_cast<int>(std::ceil(scene.size_x / scale - 1e-9)),
                                static_cast<int>(std::ceil(scene.size_y / scale - 1e-9)), scale);
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) map.Set({x, y}, navigation::Cell::kFree);
  }
  const auto cell_at = [&](double place, int count) {
    return std::clamp(static_cast<int>(std::floor(place / scale)), 0, count - 1);
  };
  for (const sim::Obstacle& obstacle : world.obstacles()) {
    const Vec2 c = obstacle.centre - scene.low;
    const double r = obstacle.radius;
    for (int y = cell_at(c.y - r, map.height()); y <= cell_at(c.y + r, map.height()); ++y) {
      for (int x = cell_at(c.x - r, map.width()); x <= cell_at(c.x + r, map.width()); ++x) {
        if (!Contains(obstacle.outline, map.CentreOf({x, y}) + scene.low)) continue;
        map.Set({x, y}, navigation::Cell::kOccupied);
      }
    }
  }
  return map;
}

MapDevice::MapDevice(DeviceContext context, std::uint16_t index)
    : Device(wire::kMap, index, "ccmorse",
             {{MessageType::kRequest, wire::kMapReqGetInfo},
              {MessageType::kRequest, wire::kMapReqGetData},
              {MessageType::kRequest, wire::kMapReqGetVector}}),
      context_(context),
      of_world_(true) {}

MapDevice::MapDevice(DeviceContext context, std::uint16_t index, navigation::OccupancyGrid map)
    : Device(wire::kMap, index, "mapfile",
             {{MessageType::kRequest, wire::kMapReqGetInfo},
              {MessageType::kRequest, wire::kMapReqGetData}}),
      context_(context),
      of_world_(false),
      map_(std::move(map)) {}

const navigation::OccupancyGrid& MapDevice::Map() {
  const sim::World& world = context_.simulation.world();
  if (!map_ || (of_world_ && revision_ != world.revision())) {
    map_ = DrawWorld(world);
    revision_ = world.revision();
  }
  return *map_;
}

bool MapDevice::Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  switch (subtype) {
    case wire::kMapReqGetInfo: {
      const navigation::OccupancyGrid& map = Map();
      wire::MapInfo info;
      info.scale = map.scale();
      info.width = static_cast<std::uint32_t>(map.width());
      info.height = static_cast<std::uint32_t>(map.height());
      // The world's own is told in the coordinates that the world's file had.
      const scene::World& world = context_.simulation.world().scene();
      const Vec2 moved = of_world_ ? world.origin - world.low : Vec2{};
      info.origin = {map.origin().x - moved.x, map.origin().y - moved.y, 0.0};
      reply.Set(info);
      return body.empty();
    }
    case wire::kMapReqGetData:
      return GetTile(body, reply);
    default:
      return GetVector(body, reply);
  }
}

bool MapDevice::GetTile(const wire::Body& body, Reply& reply) {
  wire::MapData tile;
  const navigation::OccupancyGrid& map = Map();
  const auto width = static_cast<std::uint32_t>(map.width());
  const auto height = static_cast<std::uint32_t>(map.height());
  if (!body.To(tile) || tile.width == 0 || tile.height == 0 || tile.width > kMostOfTile ||
      tile.height > kMostOfTile || tile.col >= width || tile.row >= height ||
      tile.width > width - tile.col || tile.height > height - tile.row) {
    return false;
  }
  std::vector<std::uint8_t> cells;
  cells.reserve(std::size_t{tile.width} * tile.height);
  for (std::uint32_t y = tile.row; y < tile.row + tile.height; ++y) {
    for (std::uint32_t x = tile.col; x < tile.col + tile.width; ++x) {
      cells.push_back(static_cast<std::uint8_t>(map.cells()[std::size_t{y} * width + x]));
    }
  }
  tile.data_range = 1;
  tile.data = wire::Deflate(cells);
  reply.Set(std::move(tile));
  return true;
}

bool MapDevice::GetVector(const wire::Body& body, Reply& reply) const {
  const sim::World& world = context_.simulation.world();
  wire::MapDataVector edges;
  edges.minx = world.scene().low.x;
  edges.miny = world.scene().low.y;
  edges.maxx = world.scene().high().x;
  edges.maxy = world.scene().high().y;
  for (const sim::Obstacle& obstacle : world.obstacles()) {
    const std::vector<Vec2>& outline = obstacle.outline;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i];
      const Vec2 b = outline[(i + 1) % outline.size()];
      edges.segments.push_back({a.x, a.y, b.x, b.y});
    }
  }
  reply.Set(std::move(edges));
  return body.empty();
}

}  // namespace ccmorse::servers::player
