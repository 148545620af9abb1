#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace ccmorse::fuzz {

/// Ends the program, as a fuzzer and a test both notice, when what must hold does not. Unlike
/// assert() it is there in every build.
inline void Require(bool holds, const char* what, const std::string& detail = "") {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n%s\n", what, detail.c_str());
  std::abort();
}

}  // namespace ccmorse::fuzz
