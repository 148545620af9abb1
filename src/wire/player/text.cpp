#include "wire/player/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "wire/player/messages.h"

namespace ccmorse::wire::player {
namespace {

constexpr std::string_view kHex = "0123456789abcdef";

// Takes fields as XdrWriter does.
class TextWriter {
 public:
  explicit TextWriter(std::string& out) : out_(out) {}

  template <typename T>
  void Value(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      Number(value);
    } else {
      T::Fields(value, *this);
    }
  }
  template <typename T, std::size_t n>
  void Value(const std::array<T, n>& values) {
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      Raw(values.data(), n);
    } else {
      for (const T& value : values) Value(value);
    }
  }
  void Single(double value) { Number(static_cast<float>(value)); }

  // Counts stand before the elements, and nowhere else.
  template <typename Array>
  void Count(const Array& /*items*/) {}
  void SingleItems(const std::vector<double>& items, std::size_t /*most*/ = 0) {
    Number(items.size());
    for (const double item : items) Single(item);
  }
  template <typename T>
  void Items(const std::vector<T>& items, std::size_t /*most*/ = 0) {
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      Raw(items.data(), items.size());
    } else {
      Number(items.size());
      for (const T& item : items) Value(item);
    }
  }
  void Items(const std::string& text, std::size_t /*most*/ = 0) { Raw(text.data(), text.size()); }

 private:
  template <typename T>
  void Number(T number) {
    std::array<char, 40> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    Word(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
  }
  template <typename T>
  void Raw(const T* bytes, std::size_t size) {
    std::string digits;
    for (std::size_t i = 0; i < size; ++i) {
      const auto byte = static_cast<std::uint8_t>(bytes[i]);
      digits += kHex[byte >> 4U];
      digits += kHex[byte & 15U];
    }
    Word(digits.empty() ? "-" : digits);
  }
  void Word(std::string_view word) {
    if (!out_.empty()) out_ += ' ';
    out_ += word;
  }

  std::string& out_;
};

// Takes fields as XdrReader does. Never makes room for more elements than there are characters.
class TextReader {
 public:
  explicit TextReader(std::string_view text) : rest_(text) {}

  bool ok() const { return ok_; }
  bool at_end() const { return rest_.empty(); }

  template <typename T>
  void Value(T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      Number(value);
    } else {
      T::Fields(value, *this);
    }
  }
  template <typename T, std::size_t n>
  void Value(std::array<T, n>& values) {
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      std::vector<std::uint8_t> bytes;
      Items(bytes);
      ok_ = ok_ && bytes.size() == n;
      if (ok_) std::copy(bytes.begin(), bytes.end(), values.begin());
    } else {
      for (T& value : values) Value(value);
    }
  }
  void Single(double& value) {
    float single = 0.0F;
    Number(single);
    value = double{single};
  }

  template <typename Array>
  void Count(const Array& /*items*/) {}
  void SingleItems(std::vector<double>& items, std::size_t most = 0) {
    items.resize(Length(most));
    for (double& item : items) Single(item);
  }
  template <typename T>
  void Items(std::vector<T>& items, std::size_t most = 0) {
    items.clear();
    if constexpr (std::is_same_v<T, std::uint8_t>) {
      Raw(items, most);
    } else {
      const std::size_t count = Length(most);
      for (std::size_t i = 0; i < count && ok_; ++i) Value(items.emplace_back());
    }
  }
  void Items(std::string& text, std::size_t most = 0) {
    text.clear();
    Raw(text, most);
  }

 private:
  template <typename T>
  void Number(T& number) {
    const std::string_view word = Word();
    const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
    if (read.ec != std::errc{} || read.ptr != word.data() + word.size()) ok_ = false;
  }
  std::size_t Length(std::size_t most) {
    std::size_t length = 0;
    Number(length);
    if ((most != 0 && length > most) || length > rest_.size()) ok_ = false;
    return ok_ ? length : 0;
  }
  template <typename Chars>
  void Raw(Chars& out, std::size_t most) {
    const std::string_view word = Word();
    if (word == "-") return;
    if (word.empty() || word.size() % 2 != 0 || (most != 0 && word.size() / 2 > most)) ok_ = false;
    for (std::size_t i = 0; ok_ && i < word.size(); i += 2) {
      std::uint8_t byte = 0;
      const auto read = std::from_chars(word.data() + i, word.data() + i + 2, byte, 16);
      ok_ = read.ec == std::errc{} && read.ptr == word.data() + i + 2;
      out.push_back(static_cast<typename Chars::value_type>(byte));
    }
  }
  std::string_view Word() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }

  std::string_view rest_;
  bool ok_ = true;
};

template <typename Struct>
std::optional<std::string> ToTextAs(std::span<const std::uint8_t> bytes) {
  Struct body;
  if (!Decode(bytes, body)) return {};
  std::string text;
  TextWriter writer(text);
  Struct::Fields(body, writer);
  return text;
}

template <typename Struct>
std::optional<Bytes> FromTextAs(std::string_view text) {
  Struct body;
  TextReader reader(text);
  Struct::Fields(body, reader);
  if (!reader.ok() || !reader.at_end()) return {};
  return Encode(body);
}

struct TextMessage {
  std::uint16_t code;
  std::uint8_t type;
  std::uint8_t subtype;
  std::optional<std::string> (*to_text)(std::span<const std::uint8_t>);
  std::optional<Bytes> (*from_text)(std::string_view);
};

#define PLAYER_MESSAGE(interface, code, type, subtype, name, body) \
  TextMessage{code, type, subtype, &ToTextAs<body>, &FromTextAs<body>},
constexpr std::array kTextMessages = {CCMORSE_PLAYER_MESSAGES};
#undef PLAYER_MESSAGE

const TextMessage* Find(std::uint16_t interface_code, MessageType type, std::uint8_t subtype) {
  if (type == MessageType::kAck) type = MessageType::kRequest;
  const auto* const found =
      std::find_if(kTextMessages.begin(), kTextMessages.end(), [&](const TextMessage& kind) {
        return kind.code == interface_code && kind.type == static_cast<std::uint8_t>(type) &&
               kind.subtype == subtype;
      });
  return found == kTextMessages.end() ? nullptr : found;
}

}  // namespace

std::optional<std::string> ToText(std::uint16_t interface_code, MessageType type,
                                  std::uint8_t subtype, std::span<const std::uint8_t> body) {
  const TextMessage* const kind = Find(interface_code, type, subtype);
  return kind == nullptr ? std::nullopt : kind->to_text(body);
}

std::optional<Bytes> FromText(std::uint16_t interface_code, MessageType type, std::uint8_t subtype,
                              std::string_view text) {
  const TextMessage* const kind = Find(interface_code, type, subtype);
  return kind == nullptr ? std::nullopt : kind->from_text(text);
}

}  // namespace ccmorse::wire::player
