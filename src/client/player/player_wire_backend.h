#pragma once

#include <memory>
#include <string>

#include "client/core/tcp_stream.h"
#include "client/player/backend.h"

namespace CCMorse::playerlink {

/// A connection to a Player server, over TCP (specs: player.md B), set to PULL. `stream`: a
/// connection that is open already, of which `received` was read; else it is made. Throws
/// MorseError when the server does not answer within 5 s or does not greet within 2 s.
std::unique_ptr<PlayerBackend> OpenPlayerServer(const std::string& host, std::uint32_t port,
                                                std::shared_ptr<core::TcpStream> stream = nullptr,
                                                const std::string& received = "");

}  // namespace CCMorse::playerlink
