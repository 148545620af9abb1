#pragma once

#include <string>
#include <vector>

namespace ccmorse::scene {

/// The folders that hold worlds, in the order they are looked in, whether they exist or not:
/// $CCMORSE_WORLDS, beside the running program, beside the library that this code is in, the source
/// tree, and where it was to be installed.
std::vector<std::string> WorldFolders();

/// The file of the world called `name`: NAME/models/arena.json in a world folder; "" when there is
/// none.
std::string FindWorldFile(const std::string& name);

/// Names of the worlds that FindWorldFile finds, sorted.
std::vector<std::string> ListWorlds();

}  // namespace ccmorse::scene
