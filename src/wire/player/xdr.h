#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ccmorse::wire::player {

/// Bytes of a message's body.
using Bytes = std::vector<std::uint8_t>;

/// Writes fields as Player packs them (specs: player.md B.3; XDR, RFC 4506): big endian, integers
/// of up to 32 bits in a word of four bytes, the count of an array once where its count field
/// stands and once before its elements. Hand it to a message's Fields().
class XdrWriter {
 public:
  explicit XdrWriter(Bytes& out) : out_(out) {}

  template <typename T>
  void Value(const T& value) {
    if constexpr (std::is_same_v<T, double>) {
      Long(std::bit_cast<std::uint64_t>(value));
    } else if constexpr (std::is_integral_v<T> && sizeof(T) == 8) {
      Long(static_cast<std::uint64_t>(value));
    } else if constexpr (std::is_integral_v<T>) {
      Word(static_cast<std::uint32_t>(value));  // signed ones with their sign extended
    } else {
      T::Fields(value, *this);
    }
  }
  /// A fixed array: its elements only; bytes are packed.
  template <typename T, std::size_t n>
  void Value(const std::array<T, n>& values) {
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      Raw(values.data(), n);
    } else {
      for (const T& value : values) Value(value);
    }
  }

  /// A float of the wire.
  void Single(double value) { Word(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }

  template <typename Array>
  void Count(const Array& items) {
    Word(CountOf(items));
  }
  void SingleItems(const std::vector<double>& items, std::size_t /*most*/ = 0) {
    Word(CountOf(items));
    for (const double item : items) Single(item);
  }
  template <typename T>
  void Items(const std::vector<T>& items, std::size_t /*most*/ = 0) {
    Word(CountOf(items));
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      Raw(items.data(), items.size());
    } else {
      for (const T& item : items) Value(item);
    }
  }
  /// With its NUL, which counts; an empty text is nothing at all, as in libplayerc's requests.
  void Items(const std::string& text, std::size_t /*most*/ = 0) {
    Word(CountOf(text));
    Raw(text.c_str(), CountOf(text));
  }

 private:
  template <typename T>
  static std::uint32_t CountOf(const std::vector<T>& items) {
    return static_cast<std::uint32_t>(items.size());
  }
  static std::uint32_t CountOf(const std::string& text) {
    return text.empty() ? 0 : static_cast<std::uint32_t>(text.size() + 1);
  }
  void Word(std::uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      out_.push_back(static_cast<std::uint8_t>(word >> static_cast<unsigned>(shift)));
    }
  }
  void Long(std::uint64_t number) {
    Word(static_cast<std::uint32_t>(number >> 32U));
    Word(static_cast<std::uint32_t>(number));
  }
  void Raw(const void* bytes, std::size_t size) {
    const auto* first = static_cast<const std::uint8_t*>(bytes);
    out_.insert(out_.end(), first, first + size);
    while (out_.size() % 4 != 0) out_.push_back(0);
  }

  Bytes& out_;
};

/// Reads what XdrWriter writes. Never reads beyond the end nor reserves memory for more elements
/// than there are bytes; what is short, or an array whose two counts differ, makes ok() false.
class XdrReader {
 public:
  explicit XdrReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  bool ok() const { return ok_; }
  bool at_end() const { return rest_.empty(); }

  template <typename T>
  void Value(T& value) {
    if constexpr (std::is_same_v<T, double>) {
      value = std::bit_cast<double>(Long());
    } else if constexpr (std::is_integral_v<T> && sizeof(T) == 8) {
      value = static_cast<T>(Long());
    } else if constexpr (std::is_integral_v<T>) {
      value = static_cast<T>(Word());
    } else {
      T::Fields(value, *this);
    }
  }
  template <typename T, std::size_t n>
  void Value(std::array<T, n>& values) {
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      Raw(values.data(), n);
    } else {
      for (T& value : values) Value(value);
    }
  }

  void Single(double& value) { value = double{std::bit_cast<float>(Word())}; }

  template <typename Array>
  void Count(const Array& /*items*/) {
    count_ = Word();
  }
  /// `most`: elements the struct has room for; 0: as many as come.
  template <typename T>
  void Items(std::vector<T>& items, std::size_t most = 0) {
    constexpr std::size_t kLeast = std::is_same_v<T, std::uint8_t> ? 1 : 4;  // bytes of an element
    const std::size_t count = Length(most, kLeast);
    items.clear();
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      items.resize(count);
      Raw(items.data(), count);
    } else {
      for (std::size_t i = 0; i < count && ok_; ++i) Value(items.emplace_back());
    }
  }
  void SingleItems(std::vector<double>& items, std::size_t most = 0) {
    items.resize(Length(most, 4));
    for (double& item : items) Single(item);
  }
  /// Ends at the first NUL, where there is one.
  void Items(std::string& text, std::size_t most = 0) {
    text.resize(Length(most, 1));
    Raw(text.data(), text.size());
    text.resize(std::strlen(text.c_str()));
  }

 private:
  std::size_t Length(std::size_t most, std::size_t least_bytes) {
    const std::uint32_t length = Word();
    if (length != count_ || (most != 0 && length > most) || length > rest_.size() / least_bytes) {
      ok_ = false;
    }
    return ok_ ? length : 0;
  }
  std::uint32_t Word() {
    if (rest_.size() < 4) ok_ = false;
    if (!ok_) return 0;
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word = word << 8U | rest_[i];
    rest_ = rest_.subspan(4);
    return word;
  }
  std::uint64_t Long() {
    const std::uint64_t high = Word();
    return high << 32U | Word();
  }
  void Raw(void* to, std::size_t size) {
    const std::size_t padded = (size + 3) / 4 * 4;
    if (rest_.size() < padded) ok_ = false;
    if (!ok_ || size == 0) return;
    std::memcpy(to, rest_.data(), size);
    rest_ = rest_.subspan(padded);
  }

  std::span<const std::uint8_t> rest_;
  std::uint32_t count_ = 0;
  bool ok_ = true;
};

/// The bytes of a message's body.
template <typename Body>
Bytes Encode(const Body& body) {
  Bytes bytes;
  XdrWriter writer(bytes);
  Body::Fields(body, writer);
  return bytes;
}

/// False when the bytes are not one `Body`, whole and with nothing behind it.
template <typename Body>
bool Decode(std::span<const std::uint8_t> bytes, Body& body) {
  XdrReader reader(bytes);
  Body::Fields(body, reader);
  return reader.ok() && reader.at_end();
}

}  // namespace ccmorse::wire::player
