#pragma once

#include <regex.h>

#include <stdexcept>
#include <string>

namespace course {

/// How often the POSIX extended regular expression `pattern` occurs in `text`, counted without
/// overlaps. A dot matches line ends, too. (std::regex does not compile without warnings under
/// GCC's address sanitizer.)
inline long CountMatches(const std::string& text, const std::string& pattern) {
  regex_t regex;
  if (regcomp(&regex, pattern.c_str(), REG_EXTENDED) != 0) {
    throw std::invalid_argument("no regular expression: " + pattern);
  }
  long count = 0;
  regmatch_t match;
  for (const char* at = text.c_str(); regexec(&regex, at, 1, &match, 0) == 0; ++count) {
    at += match.rm_eo > 0 ? match.rm_eo : 1;
  }
  regfree(&regex);
  return count;
}

}  // namespace course
