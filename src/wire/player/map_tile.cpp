#include "wire/player/map_tile.h"

#include <zlib.h>

namespace ccmorse::wire::player {

Bytes DeflateMapTile(std::span<const std::uint8_t> cells) {
  uLongf size = compressBound(cells.size());
  Bytes deflated(size);
  compress(deflated.data(), &size, cells.data(), cells.size());
  deflated.resize(size);
  return deflated;
}

std::optional<Bytes> InflateMapTile(std::span<const std::uint8_t> data, std::size_t size) {
  Bytes cells(size);
  uLongf inflated = size;
  if (uncompress(cells.data(), &inflated, data.data(), data.size()) == Z_OK && inflated == size) {
    return cells;
  }
  if (data.size() == size) return Bytes(data.begin(), data.end());
  return {};
}

}  // namespace ccmorse::wire::player
