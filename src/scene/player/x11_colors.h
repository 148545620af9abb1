#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/image.h"

namespace ccmorse::scene {

/// The colour that X11 calls `name`, without regard to case and blanks; nullopt for none. Unlike in
/// a scenario, "green" is (0, 255, 0) and "gray" (190, 190, 190) (specs: player.md C.1).
std::optional<Color> X11Color(std::string_view name);

/// The names X11Color knows but "gray0" to "gray100", for messages.
std::vector<std::string> X11ColorNames();

}  // namespace ccmorse::scene
