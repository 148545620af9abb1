#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "wire/player/xdr.h"

namespace ccmorse::wire::player {

/// Bytes as zlib deflates them (RFC 1950), the form in which Player sends maps.
Bytes Deflate(std::span<const std::uint8_t> plain);

/// The opposite; nothing when the bytes are none such or come to more than `most`.
std::optional<Bytes> Inflate(std::span<const std::uint8_t> deflated, std::size_t most);

}  // namespace ccmorse::wire::player
