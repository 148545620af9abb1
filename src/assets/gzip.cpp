#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

#include "assets/readers.h"
#include "base/error.h"

namespace ccmorse::assets {

bool IsGzip(const Bytes& bytes) { return bytes.size() > 2 && bytes[0] == 0x1F && bytes[1] == 0x8B; }

Bytes Gunzip(const Bytes& bytes, const std::string& name, std::size_t limit) {
  constexpr std::size_t kPiece = 1U << 20U;
  z_stream stream{};
  // 16: the header of gzip and no other.
  if (inflateInit2(&stream, 16 + MAX_WBITS) != Z_OK) throw Error("no memory for zlib");
  Bytes out;
  // zlib takes no const, and 32 bits of length.
  stream.next_in =
      const_cast<Bytef*>(bytes.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  std::size_t given = 0;
  int status = Z_OK;
  while (status == Z_OK) {
    if (stream.avail_in == 0) {
      stream.avail_in = static_cast<uInt>(std::min(bytes.size() - given, std::size_t{1} << 30U));
      given += stream.avail_in;
    }
    const std::size_t had = out.size();
    out.resize(had + kPiece);
    stream.next_out = out.data() + had;
    stream.avail_out = static_cast<uInt>(kPiece);
    status = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
    if (out.size() > limit) break;
  }
  const std::size_t at = given - stream.avail_in;
  inflateEnd(&stream);
  if (out.size() > limit) {
    throw Error(fmt::format("{}: unpacks to more than {} bytes", name, limit));
  }
  if (status != Z_STREAM_END) {
    throw Error(fmt::format("{}: offset {}: is packed by gzip, and {} there", name, at,
                            status == Z_BUF_ERROR ? "cut short" : "broken"));
  }
  return out;
}

}  // namespace ccmorse::assets
