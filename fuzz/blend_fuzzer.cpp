// ReadBlend. What must hold, whatever the bytes:
// - the result is a scene or an Error of one line that begins with the file's name;
// - within the scene every index is of something that is there, no parents run in a circle, every
//   position is finite, and there are no more objects and triangles than were allowed.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "assets/readers.h"
#include "base/error.h"
#include "fuzz/asset_check.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ccmorse::fuzz::CheckReader([&](const ccmorse::assets::AssetLimits& limits) {
    return ccmorse::assets::ReadBlend({data, data + size}, "input", limits);
  });
  return 0;
}
