#pragma once

#include <span>
#include <string>
#include <string_view>

namespace ccmorse {

/// The name among `known` that a user who typed `typed` most likely meant, by edit distance without
/// regard to case; empty when none is near (more than a third of the letters differ).
std::string NearestName(std::string_view typed, std::span<const std::string> known);

/// "; did you mean 'robots'?" for an error message, or "" when no known name is near.
std::string DidYouMean(std::string_view typed, std::span<const std::string> known);

}  // namespace ccmorse
