#pragma once

#include <stdexcept>
#include <string>

namespace ccmorse {

/// What goes wrong because of something the user can put right: a file, a value, a port.
/// what() is one line that says what, where and what to do; programs print it and stop.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

/// Reads a whole file. Throws Error that names the path and the system's reason.
std::string ReadFile(const std::string& path);

}  // namespace ccmorse
