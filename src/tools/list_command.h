#pragma once

namespace ccmorse::tools {

/// What `ccmorse list` was asked for.
struct ListArguments {
  bool names = false;         ///< nothing but names, one a line
  bool environments = false;  ///< without the scenarios that come with ccmorse
};

/// `ccmorse list`: a line for each scenario and each environment, the latter with its folder.
/// Returns the exit status. Throws Error.
int List(const ListArguments& arguments);

}  // namespace ccmorse::tools
