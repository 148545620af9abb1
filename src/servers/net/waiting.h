#pragma once

#include <algorithm>
#include <chrono>
#include <optional>
#include <string_view>
#include <vector>

#include "base/log.h"

namespace ccmorse::servers {

// What protocol servers have in common that let clients wait for data (protocol_server.h). A
// connection is held by a shared pointer and has reads(), waits(), waits_since(), heard(), name()
// and Leave(), which takes it out of `connections`.

/// See ProtocolServer::WaitingSince().
template <typename Connections>
std::optional<std::chrono::steady_clock::time_point> WaitingSince(const Connections& connections) {
  std::optional<std::chrono::steady_clock::time_point> since;
  for (const auto& connection : connections) {
    if (!connection->waits()) continue;
    since = since ? std::min(*since, connection->waits_since()) : connection->waits_since();
  }
  return since;
}

/// See ProtocolServer::LetHangingGo(). `what`: "client", for the log.
template <typename Connections>
std::optional<std::chrono::steady_clock::time_point> LetHangingGo(
    const Connections& connections, std::chrono::steady_clock::time_point waiting_since,
    std::chrono::steady_clock::duration limit, std::string_view what) {
  const auto now = std::chrono::steady_clock::now();
  std::optional<std::chrono::steady_clock::time_point> next;
  std::vector<typename Connections::value_type> hanging;
  for (const auto& connection : connections) {
    if (!connection->reads() || connection->waits()) continue;
    const auto due = std::max(waiting_since, connection->heard()) + limit;
    if (due <= now) {
      hanging.push_back(connection);
    } else {
      next = next ? std::min(*next, due) : due;
    }
  }
  for (const auto& connection : hanging) {
    LogWarning("{} {} has sent nothing for {:g} s while others wait: it is let go", what,
               connection->name(), std::chrono::duration<double>(limit).count());
    connection->Leave();
  }
  return next;
}

}  // namespace ccmorse::servers
