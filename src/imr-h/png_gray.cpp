#include "imr-h/png_gray.h"

#include <array>
#include <cstdlib>
#include <cstring>

#include "imr-h/imr_exceptions.h"

namespace imr {
namespace {

[[noreturn]] void fail(const char* why) { throw io_error(why); }

constexpr char kCut[] = "the picture ends too early";

// The bits of a deflated stream, lowest first (RFC 1951, 3.1.1).
class CBits {
 public:
  explicit CBits(const std::string& bytes) : bytes_(bytes) {}

  unsigned take(int count) {
    unsigned value = 0;
    for (int i = 0; i < count; ++i) value |= bit() << i;
    return value;
  }
  void skipToByte() { used_ = 0; }
  unsigned char byte() {
    if (at_ >= bytes_.size()) fail(kCut);
    return static_cast<unsigned char>(bytes_[at_++]);
  }
  unsigned bit() {
    if (used_ == 0) {
      current_ = byte();
      used_ = 8;
    }
    const unsigned value = current_ & 1U;
    current_ >>= 1U;
    --used_;
    return value;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
  unsigned current_ = 0;
  int used_ = 0;  // bits of the current byte that are left
};

// A prefix code by the lengths of its words (RFC 1951, 3.2.2), decoded bit by bit: maps are small.
class CCode {
 public:
  explicit CCode(const std::vector<int>& lengths) {
    for (const int length : lengths) ++count_[static_cast<std::size_t>(length)];
    count_[0] = 0;
    std::array<int, 17> first{};
    for (std::size_t n = 1; n < 16; ++n) first[n + 1] = first[n] + count_[n];
    symbols_.resize(static_cast<std::size_t>(first[16]));
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
      const auto length = static_cast<std::size_t>(lengths[symbol]);
      if (length == 0) continue;
      symbols_[static_cast<std::size_t>(first[length]++)] = static_cast<int>(symbol);
    }
  }

  int read(CBits& bits) const {
    int code = 0;
    int first = 0;
    int index = 0;
    for (std::size_t length = 1; length < 16; ++length) {
      code |= static_cast<int>(bits.bit());
      if (code - first < count_[length]) {
        return symbols_[static_cast<std::size_t>(index + code - first)];
      }
      index += count_[length];
      first = (first + count_[length]) * 2;
      code *= 2;
    }
    fail("the picture is damaged");
  }

 private:
  std::array<int, 17> count_{};
  std::vector<int> symbols_;
};

constexpr std::array<int, 29> kLengthBase = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                             15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                             67, 83, 99, 115, 131, 163, 195, 227, 258};
constexpr std::array<int, 29> kLengthBits = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                             2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
constexpr std::array<int, 30> kDistanceBase = {
    1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
    193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
constexpr std::array<int, 30> kDistanceBits = {0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                                               6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};

void readCompressed(CBits& bits, const CCode& literals, const CCode& distances, std::size_t limit,
                    std::string& out) {
  for (;;) {
    const int symbol = literals.read(bits);
    if (symbol == 256) return;
    if (symbol < 256) {
      out.push_back(static_cast<char>(symbol));
    } else {
      const auto at = static_cast<std::size_t>(symbol - 257);
      if (at >= kLengthBase.size()) fail("the picture is damaged");
      const unsigned length = static_cast<unsigned>(kLengthBase[at]) + bits.take(kLengthBits[at]);
      const auto far = static_cast<std::size_t>(distances.read(bits));
      if (far >= kDistanceBase.size()) fail("the picture is damaged");
      const std::size_t back =
          static_cast<std::size_t>(kDistanceBase[far]) + bits.take(kDistanceBits[far]);
      if (back > out.size()) fail("the picture is damaged");
      for (unsigned i = 0; i < length; ++i) out.push_back(out[out.size() - back]);
    }
    if (out.size() > limit) fail("the picture has more pixels than it says");
  }
}

// Of a zlib stream (RFC 1950) no more than `limit` bytes, and some.
std::string inflate(const std::string& bytes, std::size_t limit) {
  CBits bits(bytes);
  bits.byte();
  if ((bits.byte() & 0x20U) != 0) fail("the picture is compressed in an unknown way");
  std::string out;
  for (bool last = false; !last;) {
    last = bits.bit() == 1;
    const unsigned kind = bits.take(2);
    if (kind == 0) {
      bits.skipToByte();
      const unsigned length = bits.take(16);
      bits.take(16);  // the complement of the length
      for (unsigned i = 0; i < length; ++i) out.push_back(static_cast<char>(bits.byte()));
      if (out.size() > limit) fail("the picture has more pixels than it says");
    } else if (kind == 1) {
      std::vector<int> lengths(288, 8);
      for (std::size_t i = 144; i < 256; ++i) lengths[i] = 9;
      for (std::size_t i = 256; i < 280; ++i) lengths[i] = 7;
      readCompressed(bits, CCode(lengths), CCode(std::vector<int>(30, 5)), limit, out);
    } else if (kind == 2) {
      const unsigned literals = bits.take(5) + 257;
      const unsigned distances = bits.take(5) + 1;
      const unsigned codes = bits.take(4) + 4;
      constexpr std::array<std::size_t, 19> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                      11, 4,  12, 3, 13, 2, 14, 1, 15};
      std::vector<int> lengths(19, 0);
      for (unsigned i = 0; i < codes; ++i) lengths[kOrder[i]] = static_cast<int>(bits.take(3));
      const CCode code(lengths);
      lengths.clear();
      while (lengths.size() < literals + distances) {
        const int symbol = code.read(bits);
        if (symbol < 16) {
          lengths.push_back(symbol);
          continue;
        }
        if (symbol == 16 && lengths.empty()) fail("the picture is damaged");
        const int repeated = symbol == 16 ? lengths.back() : 0;
        const unsigned times = symbol == 16   ? bits.take(2) + 3
                               : symbol == 17 ? bits.take(3) + 3
                                              : bits.take(7) + 11;
        lengths.insert(lengths.end(), times, repeated);
      }
      const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(literals);
      const auto end = middle + static_cast<std::ptrdiff_t>(distances);
      readCompressed(bits, CCode({lengths.begin(), middle}), CCode({middle, end}), limit, out);
    } else {
      fail("the picture is damaged");
    }
  }
  return out;
}

unsigned number(const std::string& bytes, std::size_t at) {
  if (bytes.size() < 4 || at > bytes.size() - 4) fail(kCut);
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

// The byte before, above, or diagonally before that comes nearest to their plane (ISO/IEC
// 15948, 9.4).
int paeth(int left, int up, int corner) {
  const int by_left = std::abs(up - corner);
  const int by_up = std::abs(left - corner);
  const int by_corner = std::abs(left + up - 2 * corner);
  if (by_left <= by_up && by_left <= by_corner) return left;
  return by_up <= by_corner ? up : corner;
}

}  // namespace

SGrayImage decodePng(const std::string& bytes) {
  if (bytes.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) fail("this is no PNG");
  SGrayImage image;
  unsigned depth = 0;
  unsigned kind = 0;
  std::string packed;
  std::string palette;
  std::string alpha;  // of palette entries
  for (std::size_t at = 8;;) {
    const std::size_t length = number(bytes, at);
    if (bytes.size() - at < 12 || length > bytes.size() - at - 12) fail(kCut);
    const std::string name = bytes.substr(at + 4, 4);
    if (name == "IHDR" && length == 13) {
      const unsigned width = number(bytes, at + 8);
      const unsigned height = number(bytes, at + 12);
      constexpr std::uint64_t kMost = std::uint64_t{1} << 26U;
      if (width == 0 || height == 0 || std::uint64_t{width} * height > kMost) {
        fail("the picture must have between 1 and 2^26 pixels");
      }
      image.width = static_cast<int>(width);
      image.height = static_cast<int>(height);
      depth = static_cast<unsigned char>(bytes[at + 16]);
      kind = static_cast<unsigned char>(bytes[at + 17]);
      if (bytes[at + 20] != 0) fail("an interlaced PNG; save it without interlacing");
    }
    if (name == "IDAT") packed.append(bytes, at + 8, length);
    if (name == "PLTE") palette = bytes.substr(at + 8, length);
    if (name == "tRNS" && kind == 3) alpha = bytes.substr(at + 8, length);
    if (name == "IEND") break;
    at += length + 12;
  }
  constexpr std::array<unsigned, 7> kChannels = {1, 0, 3, 1, 2, 0, 4};
  const bool small = depth == 1 || depth == 2 || depth == 4;
  if (image.width == 0 || kind >= kChannels.size() || kChannels[kind] == 0 ||
      !(depth == 8 || (depth == 16 && kind != 3) || (small && (kind == 0 || kind == 3)))) {
    fail("a PNG of an unknown kind");
  }
  const std::size_t channels = kChannels[kind];
  const std::size_t bits = channels * depth;
  const std::size_t step = bits < 8 ? 1 : bits / 8;
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  const std::size_t row = (width * bits + 7) / 8;
  std::string raw = inflate(packed, (row + 1) * height + 65536);
  if (raw.size() < (row + 1) * height) fail(kCut);

  const auto level = [](const std::string& text, std::size_t at) {
    return static_cast<int>(static_cast<unsigned char>(text[at]));
  };
  const double most = static_cast<double>((1U << depth) - 1);
  image.light.reserve(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    const std::size_t begin = y * (row + 1) + 1;
    const int filter = level(raw, begin - 1);
    if (filter > 4) fail("the picture is damaged");
    for (std::size_t i = 0; i < row; ++i) {
      const int left = i >= step ? level(raw, begin + i - step) : 0;
      const int up = y > 0 ? level(raw, begin + i - row - 1) : 0;
      const int corner = y > 0 && i >= step ? level(raw, begin + i - step - row - 1) : 0;
      const std::array<int, 5> add = {0, left, up, (left + up) / 2, paeth(left, up, corner)};
      raw[begin + i] =
          static_cast<char>(level(raw, begin + i) + add[static_cast<std::size_t>(filter)]);
    }
    // Sample `n` of the row, 0 .. most.
    const auto sample = [&](std::size_t n) {
      if (depth == 16) return level(raw, begin + 2 * n) * 256 + level(raw, begin + 2 * n + 1);
      if (depth == 8) return level(raw, begin + n);
      const std::size_t bit = n * depth;
      return level(raw, begin + bit / 8) >> (8 - depth - bit % 8) & ((1 << depth) - 1);
    };
    for (std::size_t x = 0; x < width; ++x) {
      double light = 0.0;
      double cover = 1.0;
      if (kind == 3) {
        const auto entry = static_cast<std::size_t>(sample(x));
        if (palette.size() < entry * 3 + 3) fail("the picture is damaged");
        for (std::size_t c = 0; c < 3; ++c) light += level(palette, entry * 3 + c) / (3 * 255.0);
        if (entry < alpha.size()) cover = level(alpha, entry) / 255.0;
      } else {
        const std::size_t colors = channels - (channels % 2 == 0 ? 1 : 0);
        for (std::size_t c = 0; c < colors; ++c) {
          light += sample(x * channels + c) / (most * static_cast<double>(colors));
        }
        if (colors < channels) cover = sample(x * channels + colors) / most;
      }
      image.light.push_back(light * cover + (1.0 - cover));
    }
  }
  return image;
}

}  // namespace imr
