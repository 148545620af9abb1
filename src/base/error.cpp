#include "base/error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace ccmorse {

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  // Copying nothing counts as a failure, but an empty file can be read. Opening a folder succeeds
  // on Linux; only reading from it fails.
  const bool is_empty = file.peek() == std::ifstream::traits_type::eof() && file.eof();
  if (!is_empty && (!file || !(content << file.rdbuf()))) {
    throw Error("cannot read " + path + ": " + std::strerror(errno));
  }
  return content.str();
}

}  // namespace ccmorse
