#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <string>
#include <string_view>

namespace CCMorse::core {

/// What a Player server says first (specs: player.md B.1).
inline constexpr std::string_view kPlayerGreeting = "Player v.";
/// How the error ends of a connection to a simulator that met a Player server.
inline constexpr std::string_view kPlayerServerThere = " greets as a Player server does";

/// Connects `socket`, which runs on `io`, within about `limit`. The reason when that fails, else
/// "".
std::string ConnectTcp(boost::asio::io_context& io, boost::asio::ip::tcp::socket& socket,
                       const std::string& host, int port, std::chrono::milliseconds limit);

}  // namespace CCMorse::core
