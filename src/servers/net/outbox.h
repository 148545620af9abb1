#pragma once

#include <boost/asio/write.hpp>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "servers/net/stream_socket.h"

namespace ccmorse::servers {

/// Bytes on their way out of one socket. What the socket takes at once goes at once; the rest
/// follows as the peer reads. One thread; belongs to what owns the socket.
class Outbox {
 public:
  /// `socket` is non-blocking and outlives the outbox.
  explicit Outbox(StreamSocket& socket) : socket_(socket) {}

  /// What the next Flush() sends; to be appended to.
  std::string& text() { return waiting_; }
  /// Bytes that have not gone yet.
  std::size_t size() const { return waiting_.size() + sending_.size() - sent_; }
  /// A write is under way.
  bool busy() const { return busy_; }

  /// `keep` holds the owner alive; `done` is called after each write that did not end at once or
  /// failed, with its error.
  template <typename Done>
  void Flush(std::shared_ptr<void> keep, Done done) {
    if (busy_ || waiting_.empty()) return;
    sending_.swap(waiting_);
    waiting_.clear();
    ErrorCode error;
    sent_ = socket_.write_some(boost::asio::buffer(sending_), error);
    if (error && error != boost::asio::error::would_block) {
      sending_.clear();
      sent_ = 0;
      return done(error);
    }
    if (error) sent_ = 0;
    if (sent_ == sending_.size()) {
      sending_.clear();
      sent_ = 0;
      return;
    }
    busy_ = true;
    boost::asio::async_write(socket_, boost::asio::buffer(sending_) + sent_,
                             [this, keep = std::move(keep), done](ErrorCode failed, std::size_t) {
                               busy_ = false;
                               sending_.clear();
                               sent_ = 0;
                               done(failed);
                             });
  }

 private:
  StreamSocket& socket_;
  std::string waiting_;
  std::string sending_;
  std::size_t sent_ = 0;
  bool busy_ = false;
};

}  // namespace ccmorse::servers
