#pragma once

#include <string>

namespace ccmorse::tools {

/// What `ccmorse info` was asked for.
struct InfoArguments {
  std::string file;   ///< as assets::FindAsset takes it
  bool json = false;  ///< for programs
};

/// `ccmorse info`: lists what a file of shapes holds: objects with their sizes, triangles, physics
/// and game properties, and what of it is not read. Throws Error.
int Info(const InfoArguments& arguments);

}  // namespace ccmorse::tools
