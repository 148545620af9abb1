#include "servers/net/warm_path.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

namespace ccmorse::servers {

WarmPath::WarmPath() {
  constexpr int kKind = SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK;
  const int listener = ::socket(AF_INET, kKind, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* const where = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = sizeof address;
  if (listener >= 0 && ::bind(listener, where, size) == 0 && ::listen(listener, 1) == 0 &&
      ::getsockname(listener, where, &size) == 0) {
    ends_[0] = ::socket(AF_INET, kKind, 0);
    // Over loopback the connection is there, or as good as, when connect() comes back.
    static_cast<void>(::connect(ends_[0], where, size));
    sockaddr_in peer{};
    sockaddr_in own{};
    socklen_t peer_size = sizeof peer;
    socklen_t own_size = sizeof own;
    ends_[1] = ::accept4(listener, reinterpret_cast<sockaddr*>(&peer), &peer_size,
                         SOCK_CLOEXEC | SOCK_NONBLOCK);
    // Another program may have been faster.
    if (::getsockname(ends_[0], reinterpret_cast<sockaddr*>(&own), &own_size) != 0 ||
        own.sin_port != peer.sin_port) {
      ::close(ends_[1]);
      ends_[1] = -1;
    }
    const int on = 1;
    ::setsockopt(ends_[0], IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  }
  ::close(listener);
}

WarmPath::~WarmPath() {
  for (const int end : ends_) ::close(end);
}

bool WarmPath::Warm() {
  if (!Works()) return false;
  if (::send(ends_[0], block_.data(), block_.size(), MSG_NOSIGNAL) < 0) return false;
  while (::recv(ends_[1], block_.data(), block_.size(), 0) > 0) {
  }
  return true;
}

}  // namespace ccmorse::servers
