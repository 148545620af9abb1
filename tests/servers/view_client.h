#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdint>
#include <string>

#include "base/json.h"

namespace ccmorse::servers {

/// Looks at a live view as its page does (docs/protocols/view.md). Not thread safe.
class ViewClient {
 public:
  // Throws where the server refuses.
  explicit ViewClient(int port, const std::string& origin = "", const std::string& target = "/view")
      : socket_(io_) {
    boost::beast::get_lowest_layer(socket_).connect(boost::asio::ip::tcp::endpoint(
        boost::asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)));
    socket_.set_option(boost::beast::websocket::stream_base::decorator(
        [origin](boost::beast::websocket::request_type& request) {
          if (!origin.empty()) request.set(boost::beast::http::field::origin, origin);
        }));
    socket_.handshake("localhost:" + std::to_string(port), target);
  }

  // The next message; binary ones are confirmed.
  std::string Next() {
    boost::beast::flat_buffer buffer;
    socket_.read(buffer);
    binary_ = socket_.got_binary();
    if (binary_) Send("k");
    return boost::beast::buffers_to_string(buffer.data());
  }
  std::string NextText() {
    for (;;) {
      std::string text = Next();
      if (!binary_) return text;
    }
  }
  std::string NextFrame() {
    for (;;) {
      std::string frame = Next();
      if (binary_) return frame;
    }
  }
  void Send(const std::string& text) {
    socket_.text(true);
    socket_.write(boost::asio::buffer(text));
  }
  Json Call(const std::string& call) {
    Send(R"({"id": 7, "call": )" + call + "}");
    return Json::Parse(NextText());
  }

 private:
  boost::asio::io_context io_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_;
  bool binary_ = false;
};

}  // namespace ccmorse::servers
