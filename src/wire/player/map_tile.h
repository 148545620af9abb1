#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "wire/player/xdr.h"

namespace ccmorse::wire::player {

/// The cells of a map's tile as Player sends them: deflated by zlib (specs: player.md B.7).
Bytes DeflateMapTile(std::span<const std::uint8_t> cells);

/// The `size` cells of a tile that came: deflated, or plain from a server without zlib. Nothing
/// when it holds another number of cells or is damaged.
std::optional<Bytes> InflateMapTile(std::span<const std::uint8_t> data, std::size_t size);

}  // namespace ccmorse::wire::player
