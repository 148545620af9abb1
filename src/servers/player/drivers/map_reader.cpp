#include "servers/player/drivers/map_reader.h"

#include <algorithm>

#include "wire/player/deflate.h"

namespace ccmorse::servers::player {
namespace {

using navigation::Cell;
using navigation::OccupancyGrid;

constexpr std::uint32_t kTile = 640;                // cells each way, at most
constexpr std::uint64_t kMostMapCells = 1U << 28U;  // what a grid may have

}  // namespace

std::optional<OccupancyGrid> ReadMap(Device& map) {
  Reply info_reply;
  wire::MapInfo info;
  if (!map.Request(wire::kMapReqGetInfo, {}, info_reply) || !info_reply.body().To(info) ||
      info.width == 0 || info.height == 0 ||
      std::uint64_t{info.width} * info.height > kMostMapCells || !(info.scale > 0.0) ||
      info.origin.pa != 0.0) {
    return std::nullopt;
  }
  OccupancyGrid grid(static_cast<int>(info.width), static_cast<int>(info.height), info.scale,
                     {info.origin.px, info.origin.py});
  for (std::uint32_t row = 0; row < info.height; row += kTile) {
    for (std::uint32_t column = 0; column < info.width; column += kTile) {
      wire::MapData tile;
      tile.col = column;
      tile.row = row;
      tile.width = std::min(kTile, info.width - column);
      tile.height = std::min(kTile, info.height - row);
      const wire::MapData asked = tile;
      Reply reply;
      if (!map.Request(wire::kMapReqGetData, wire::Body::Of(asked), reply) ||
          !reply.body().To(tile)) {
        return std::nullopt;
      }
      const std::size_t size = std::size_t{asked.width} * asked.height;
      const auto cells = wire::Inflate(tile.data, size);
      if (!cells || cells->size() != size) return std::nullopt;
      for (std::size_t i = 0; i < size; ++i) {
        const auto cell = static_cast<std::int8_t>((*cells)[i]);
        grid.Set(
            {static_cast<int>(column + i % asked.width), static_cast<int>(row + i / asked.width)},
            cell > 0   ? Cell::kOccupied
            : cell < 0 ? Cell::kFree
                       : Cell::kUnknown);
      }
    }
  }
  return grid;
}

}  // namespace ccmorse::servers::player
