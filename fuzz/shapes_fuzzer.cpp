// ReadGltf, ReadObj, ReadStl and ReadCollada: the first byte says which (g, o, s, c), the rest is
// the file; files that it names are the same bytes again. What must hold: asset_check.h.

#include <cstddef>
#include <cstdint>
#include <string>

#include "assets/readers.h"
#include "base/error.h"
#include "fuzz/asset_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace assets = ccmorse::assets;
  if (size == 0) return 0;
  const assets::Bytes bytes(data + 1, data + size);
  const assets::FindFile find = [&bytes](const std::string&) { return bytes; };
  ccmorse::fuzz::CheckReader([&](const assets::AssetLimits& limits) {
    switch (data[0]) {
      case 'g':
        return assets::ReadGltf(bytes, "input", find, limits);
      case 'o':
        return assets::ReadObj({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, "input",
                               find, limits);
      case 's':
        return assets::ReadStl(bytes, "input", limits);
      default:
        return assets::ReadCollada(bytes, "input", limits);
    }
  });
  return 0;
}
