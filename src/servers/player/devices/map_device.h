#pragma once

#include <cstdint>
#include <optional>

#include "navigation/occupancy_grid.h"
#include "servers/player/device.h"
#include "servers/player/device_context.h"

namespace ccmorse::servers::player {

/// The world's floor with the boxes that stand and the meshes at robots' height, a cell being
/// occupied where its middle is inside one. Cells of 0.02 m as in the course's map, or larger ones
/// so that there are at most 2048 each way.
navigation::OccupancyGrid DrawWorld(const sim::World& world);

/// map (specs: player.md B.7): the world as a grid, drawn anew when its boxes have changed, or a
/// grid that is given. Tiles are deflated, up to 640 x 640 cells. GET_VECTOR has the world's edges.
class MapDevice : public Device {
 public:
  MapDevice(DeviceContext context, std::uint16_t index);
  MapDevice(DeviceContext context, std::uint16_t index, navigation::OccupancyGrid map);

 protected:
  bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override;

 private:
  const navigation::OccupancyGrid& Map();
  bool GetTile(const wire::Body& body, Reply& reply);
  bool GetVector(const wire::Body& body, Reply& reply) const;

  DeviceContext context_;
  bool of_world_;
  std::optional<navigation::OccupancyGrid> map_;
  std::uint64_t revision_ = 0;  // of the world that it shows
};

}  // namespace ccmorse::servers::player
