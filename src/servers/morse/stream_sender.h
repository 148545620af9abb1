#pragma once

#include <array>
#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "servers/net/stream_socket.h"

namespace ccmorse::servers {

/// One client of a sensor's stream (specs: morse.md A.3). A reader that has not taken all of its
/// last line yet misses those that come meanwhile; so it never has more than one, which it shares
/// with the others. What it writes is read and forgotten.
class StreamReader {
 public:
  explicit StreamReader(StreamSocket socket) : socket_(std::move(socket)) {}

  /// False once it has left. Any thread.
  bool connected() const { return connected_; }
  /// Would it take a line? Any thread; what is said of a slow reader may be out of date.
  bool ready() const { return connected_ && !busy_; }

 private:
  friend class StreamSender;
  StreamSocket socket_;  // only the sender's thread uses it
  std::array<char, 4096> block_{};
  std::atomic<bool> connected_{true};
  std::atomic<bool> busy_{false};  // a line is on its way
};

/// Puts the lines of sensors' streams into words and sends them: at once, or on a thread of its
/// own, as a long line to many readers takes milliseconds, by which a tick would come too late. All
/// functions are called on the run's thread.
class StreamSender {
 public:
  using Readers = std::vector<std::shared_ptr<StreamReader>>;

  /// The line of one tick, without its end, and who gets it.
  struct Line {
    std::shared_ptr<const Readers> readers;
    std::function<std::string()> text;  ///< called at most once, on the sender's thread
  };

  /// `io` is the run's; where the sender has a thread of its own, which starts with the first
  /// reader, it is not used.
  StreamSender(boost::asio::io_context& io, bool own_thread);
  ~StreamSender() { Close(); }
  StreamSender(const StreamSender&) = delete;
  StreamSender& operator=(const StreamSender&) = delete;

  /// Takes over a connection.
  std::shared_ptr<StreamReader> Take(boost::asio::ip::tcp::socket socket);
  /// Connected now.
  std::size_t readers() const { return readers_; }

  /// Sends the lines in their order to those of their readers that are ready. Returns at once,
  /// whatever the readers do; only where the lines of kMostTicks calls have not been put into words
  /// yet, which is more than a computer can do that keeps up with the clock, it waits.
  void Send(std::vector<Line> lines);

  /// Sends what was handed over and closes all connections. Idempotent.
  void Close();

 private:
  static constexpr int kMostTicks = 64;

  void Start(const std::shared_ptr<StreamReader>& reader);
  void Read(const std::shared_ptr<StreamReader>& reader);
  void SendNow(const std::vector<Line>& lines);
  void SendTo(const std::shared_ptr<StreamReader>& reader,
              const std::shared_ptr<const std::string>& line);
  void Drop(StreamReader& reader);
  void CloseAll();

  const bool own_thread_;
  boost::asio::io_context own_io_{1};
  boost::asio::io_context& io_;
  std::optional<boost::asio::executor_work_guard<boost::asio::io_context::executor_type>> work_;
  std::atomic<std::size_t> readers_{0};
  std::set<std::shared_ptr<StreamReader>> connected_;  // the sender's thread's
  bool closed_ = false;
  std::mutex mutex_;
  std::condition_variable sent_;
  int waiting_ = 0;  // calls of Send() whose lines have not been sent; under the mutex
  std::thread thread_;
};

}  // namespace ccmorse::servers
