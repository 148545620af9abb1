#include "client/core/address.h"

#include <algorithm>
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

constexpr std::string_view kInProcess = "sim:";

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

Location ParseAddress(const std::string& address, int port, const char* function) {
  if (IsInProcess(address)) return {"sim", address, 0};
  Location location{"", address, port};
  const std::size_t mark = address.find("://");
  if (mark == std::string::npos) return location;
  location.scheme = address.substr(0, mark);
  location.host = address.substr(mark + 3);
  if (location.scheme != "morse" && location.scheme != "player") {
    throw MorseError(
        "an address begins with morse://, player:// or sim:, not " + location.scheme + "://",
        function);
  }
  while (!location.host.empty() && location.host.back() == '/') location.host.pop_back();
  const std::size_t colon = location.host.rfind(':');
  if (colon == std::string::npos) {
    if (location.scheme == "morse" && port == kPlayerPort) location.port = kMorsePort;
    return location;
  }
  const std::string digits = location.host.substr(colon + 1);
  if (digits.empty() || digits.size() > 5 ||
      digits.find_first_not_of("0123456789") != std::string::npos) {
    throw MorseError("there is no port in " + address, function);
  }
  location.port = std::stoi(digits);
  location.host.resize(colon);
  return location;
}

bool IsInProcess(std::string_view address) { return address.starts_with(kInProcess); }

std::string AddressText(const std::string& host, int port) {
  return IsInProcess(host) ? host : host + ":" + std::to_string(port);
}

InProcessAddress ParseInProcess(std::string_view address, const char* function) {
  InProcessAddress parsed;
  address.remove_prefix(kInProcess.size());
  const std::size_t mark = address.find('?');
  parsed.simulation = address.substr(0, mark);
  std::string_view rest = mark == std::string_view::npos ? "" : address.substr(mark + 1);
  char before = '?';
  while (!rest.empty()) {
    const std::size_t end = rest.find('&');
    const std::string_view option = rest.substr(0, end);
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
    const std::string_view value = option.substr(std::min(option.find('=') + 1, option.size()));
    if (option.starts_with("protocol=")) {
      parsed.protocol = value;
    } else if (option.starts_with("robot=")) {
      parsed.robot = value;
    } else {
      parsed.simulation += before;
      parsed.simulation += option;
      before = '&';
    }
  }
  if (parsed.protocol != "morse" && parsed.protocol != "player") {
    throw MorseError("sim: option protocol is '" + parsed.protocol + "', must be morse or player",
                     function);
  }
  if (!parsed.robot.empty() && parsed.protocol != "player") {
    throw MorseError(
        "sim: option robot goes with protocol=player; a simulator's proxies name their robot",
        function);
  }
  return parsed;
}

}  // namespace CCMorse::core
