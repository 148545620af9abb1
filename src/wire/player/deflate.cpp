#include "wire/player/deflate.h"

#include <zlib.h>

#include <algorithm>

namespace ccmorse::wire::player {

Bytes Deflate(std::span<const std::uint8_t> plain) {
  uLongf size = compressBound(static_cast<uLong>(plain.size()));
  Bytes deflated(size);
  // Cannot fail with a buffer of that size, but for want of memory: then there are no bytes.
  if (compress2(deflated.data(), &size, plain.data(), static_cast<uLong>(plain.size()),
                Z_BEST_SPEED) != Z_OK) {
    size = 0;
  }
  deflated.resize(size);
  return deflated;
}

std::optional<Bytes> Inflate(std::span<const std::uint8_t> deflated, std::size_t most) {
  // No stream of so many bytes comes to more (RFC 1951: 258 bytes in 2 bits at best).
  constexpr std::size_t kMostRatio = 1032;
  Bytes plain(std::min(most, deflated.size() * kMostRatio));
  auto size = static_cast<uLongf>(plain.size());
  if (uncompress(plain.data(), &size, deflated.data(), static_cast<uLong>(deflated.size())) !=
      Z_OK) {
    return {};
  }
  plain.resize(size);
  return plain;
}

}  // namespace ccmorse::wire::player
