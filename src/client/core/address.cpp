#include "client/core/address.h"

#include <charconv>
#include <cstdlib>
#include <string_view>

#include "libCCMorse/MorseError.h"

namespace CCMorse::core {
namespace {

// The value of an environment variable; "" when it is not set.
std::string_view Variable(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

}  // namespace

std::pair<std::string, int> AddressFor(const std::string& host, int port) {
  const bool usual = (host == "localhost" || host == "127.0.0.1") && (port == 4000 || port == 6665);
  if (!usual) return {host, port};
  const std::string_view other_host = Variable("CCMORSE_HOST");
  const std::string_view other_port = Variable("CCMORSE_PORT");
  std::pair<std::string, int> address{other_host.empty() ? host : std::string(other_host), port};
  if (!other_port.empty()) {
    const char* const end = other_port.data() + other_port.size();
    const auto read = std::from_chars(other_port.data(), end, address.second);
    if (read.ec != std::errc{} || read.ptr != end || address.second < 1 || address.second > 65535) {
      throw MorseError("CCMORSE_PORT is '" + std::string(other_port) + "', must be 1..65535",
                       "MorseClient::MorseClient()");
    }
  }
  return address;
}

}  // namespace CCMorse::core
