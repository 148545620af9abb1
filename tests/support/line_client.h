#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ccmorse::testing {

/// A bare TCP client for tests: sends bytes, receives lines. Not thread safe.
class LineClient {
 public:
  /// Connects to 127.0.0.1. Throws std::runtime_error.
  explicit LineClient(int port);
  ~LineClient();
  LineClient(const LineClient&) = delete;
  LineClient& operator=(const LineClient&) = delete;

  void Send(std::string_view bytes);

  /// The next line without its end; nothing when none comes in time or the peer has closed.
  std::optional<std::string> ReadLine(
      std::chrono::milliseconds timeout = std::chrono::milliseconds(10000));

  /// The next `size` bytes; nothing when they do not come in time or the peer has closed.
  std::optional<std::string> ReadBytes(
      std::size_t size, std::chrono::milliseconds timeout = std::chrono::milliseconds(10000));

  /// Sends `line` and a line end and returns the next line ("" when none comes).
  std::string Ask(std::string_view line);

  /// Did the peer close the connection, at the latest within the time?
  bool IsClosed(std::chrono::milliseconds timeout = std::chrono::milliseconds(10000));

  /// Closes at once with a reset instead of an orderly end.
  void Reset();

 private:
  bool Fill(std::chrono::milliseconds timeout);

  int socket_ = -1;
  bool closed_ = false;
  std::string buffer_;
};

}  // namespace ccmorse::testing
