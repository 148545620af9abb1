#pragma once

#include <string>
#include <string_view>

namespace ccmorse {

/// Bytes as text (RFC 4648, section 4, with padding), and back. FromBase64 throws Error on anything
/// that ToBase64 does not write.
std::string ToBase64(std::string_view bytes);
std::string FromBase64(std::string_view text);

}  // namespace ccmorse
