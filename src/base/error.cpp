#include "base/error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace ccmorse {

std::string ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  // Opening a folder succeeds on Linux; only reading from it fails.
  if (!file || !(content << file.rdbuf())) {
    throw Error("cannot read " + path + ": " + std::strerror(errno));
  }
  return content.str();
}

}  // namespace ccmorse
