#pragma once

#include <cstdint>
#include <span>
#include <typeinfo>

#include "wire/player/xdr.h"

namespace ccmorse::wire::player {

/// The body of a message on its way: bytes from a wire, or the struct itself where both ends live
/// in one program, so that nothing is packed and no double becomes a float. A view: it lives as
/// long as what it was made of. Made by value, passed by reference.
class Body {
 public:
  /// No body.
  Body() = default;
  explicit Body(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  template <typename Struct>
  static Body Of(const Struct& value) {
    Body body;
    body.value_ = &value;
    body.type_ = &typeid(Struct);
    body.encode_ = [](const void* of) { return Encode(*static_cast<const Struct*>(of)); };
    return body;
  }

  bool empty() const { return type_ == nullptr && bytes_.empty(); }

  /// Copies or decodes it into `out`; false when it is another struct or the bytes are none such.
  template <typename Struct>
  bool To(Struct& out) const {
    if (type_ == nullptr) return Decode(bytes_, out);
    if (*type_ != typeid(Struct)) return false;
    out = *static_cast<const Struct*>(value_);
    return true;
  }

  /// As it goes over the wire.
  Bytes ToBytes() const {
    return type_ == nullptr ? Bytes(bytes_.begin(), bytes_.end()) : encode_(value_);
  }

 private:
  std::span<const std::uint8_t> bytes_;
  const void* value_ = nullptr;
  const std::type_info* type_ = nullptr;
  Bytes (*encode_)(const void*) = nullptr;
};

}  // namespace ccmorse::wire::player
