#include "client/core/tcp_connect.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <future>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace CCMorse::core {

namespace asio = boost::asio;
using asio::ip::tcp;
using ErrorCode = boost::system::error_code;

namespace {

struct Endpoints {
  std::string reason;  // why there are none
  std::vector<tcp::endpoint> found;
};

// The system's look-up of names has no time limit, so it runs in a thread that may be left behind.
Endpoints Resolve(const std::string& host, int port, std::chrono::milliseconds limit) {
  if (host == "localhost") {  // always this machine (RFC 6761), known to its resolver or not
    const auto number = static_cast<std::uint16_t>(port);
    return {
        "",
        {{asio::ip::address_v4::loopback(), number}, {asio::ip::address_v6::loopback(), number}}};
  }
  auto promise = std::make_shared<std::promise<Endpoints>>();
  std::future<Endpoints> future = promise->get_future();
  std::thread([promise, host, port] {
    Endpoints answer;
    ErrorCode error;
    asio::io_context io;
    tcp::resolver resolver(io);
    for (const auto& entry : resolver.resolve(host, std::to_string(port), error)) {
      answer.found.push_back(entry.endpoint());
    }
    if (error) answer.reason = error.message();
    promise->set_value(std::move(answer));
  }).detach();
  if (future.wait_for(limit) != std::future_status::ready) {
    return {"the host name was not resolved in time", {}};
  }
  Endpoints answer = future.get();
  if (answer.reason.empty() && answer.found.empty()) answer.reason = "the host has no address";
  return answer;
}

}  // namespace

int ConnectTcp(const std::string& host, int port, std::chrono::milliseconds limit,
               std::string* reason) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  const Endpoints endpoints = Resolve(host, port, limit);
  *reason = endpoints.reason;
  if (!reason->empty()) return -1;
  asio::io_context io;
  tcp::socket socket(io);
  ErrorCode outcome = asio::error::would_block;
  asio::async_connect(socket, endpoints.found,
                      [&outcome](const ErrorCode& ec, const tcp::endpoint&) { outcome = ec; });
  io.run_until(deadline);
  if (outcome == asio::error::would_block) {
    ErrorCode ignored;
    socket.close(ignored);
    io.restart();
    io.run();  // the cancelled connect still refers to `outcome`
    *reason = "no answer within " + std::to_string((limit.count() + 999) / 1000) + " s";
    return -1;
  }
  if (outcome) {
    *reason = outcome.message();
    return -1;
  }
  ErrorCode failed;
  // Without it, the kernel holds small messages back for up to 40 ms.
  socket.set_option(tcp::no_delay(true), failed);
  const int handle = socket.release(failed);
  if (failed) *reason = failed.message();
  return failed ? -1 : handle;
}

}  // namespace CCMorse::core
