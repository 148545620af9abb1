#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace CCMorse::core {

/// What a Player server says first (specs: player.md B.1).
inline constexpr std::string_view kPlayerGreeting = "Player v.";
/// How the error ends of a connection to a simulator that met a Player server.
inline constexpr std::string_view kPlayerServerThere = " greets as a Player server does";

/// A socket that is connected to host and port, without Nagle's delay, which the caller closes.
/// Within about `limit`; -1 when that fails, and the `reason`.
int ConnectTcp(const std::string& host, int port, std::chrono::milliseconds limit,
               std::string* reason);

}  // namespace CCMorse::core
