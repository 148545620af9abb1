#include "servers/morse/stream_sender.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>

#include "servers/net/stream_socket.h"

namespace ccmorse::servers {

namespace asio = boost::asio;
using asio::ip::tcp;

StreamSender::StreamSender(asio::io_context& io, bool own_thread)
    : own_thread_(own_thread), io_(own_thread ? own_io_ : io) {}

std::shared_ptr<StreamReader> StreamSender::Take(tcp::socket socket) {
  ErrorCode error;
  const auto protocol = socket.local_endpoint(error).protocol();
  StreamSocket own(io_);
  if (!error) {
    // From the run's io_context to the sender's.
    const auto handle = socket.release(error);
    if (!error) own.assign(protocol, handle, error);
  }
  own.non_blocking(true, error);
  auto reader = std::make_shared<StreamReader>(std::move(own));
  ++readers_;
  if (own_thread_ && !thread_.joinable()) {
    work_.emplace(io_.get_executor());
    thread_ = std::thread([this] {
      // When it is woken, it does not interrupt the run where they share a processor. May fail.
      const sched_param priority{};
      ::pthread_setschedparam(::pthread_self(), SCHED_BATCH, &priority);
      io_.run();
    });
  }
  if (own_thread_) {
    asio::post(io_, [this, reader] { Start(reader); });
  } else {
    Start(reader);
  }
  return reader;
}

void StreamSender::Start(const std::shared_ptr<StreamReader>& reader) {
  connected_.insert(reader);
  Read(reader);
}

// So we notice when it leaves.
void StreamSender::Read(const std::shared_ptr<StreamReader>& reader) {
  reader->socket_.async_read_some(asio::buffer(reader->block_),
                                  [this, reader](ErrorCode error, std::size_t) {
                                    if (!reader->connected_) return;
                                    if (error) return Drop(*reader);
                                    Read(reader);
                                  });
}

void StreamSender::Send(std::vector<Line> lines) {
  if (lines.empty()) return;
  if (!own_thread_) return SendNow(lines);
  {
    std::unique_lock lock(mutex_);
    sent_.wait(lock, [this] { return waiting_ < kMostTicks; });
    ++waiting_;
  }
  asio::post(io_, [this, lines = std::move(lines)] {
    SendNow(lines);
    {
      const std::lock_guard lock(mutex_);
      --waiting_;
    }
    sent_.notify_one();
  });
}

void StreamSender::SendNow(const std::vector<Line>& lines) {
  for (const Line& line : lines) {
    std::shared_ptr<const std::string> text;
    for (const auto& reader : *line.readers) {
      // A slow reader misses lines; it never holds up anybody else (specs: morse.md A.3).
      if (!reader->ready()) continue;
      // Where nobody takes it, nothing is put into words; and it is once, however many do.
      if (text == nullptr) text = std::make_shared<const std::string>(line.text() + '\n');
      SendTo(reader, text);
    }
  }
}

void StreamSender::SendTo(const std::shared_ptr<StreamReader>& reader,
                          const std::shared_ptr<const std::string>& line) {
  ErrorCode error;
  std::size_t sent = reader->socket_.write_some(asio::buffer(*line), error);
  if (error == asio::error::would_block) {
    sent = 0;
  } else if (error) {
    return Drop(*reader);
  }
  if (sent == line->size()) return;
  reader->busy_ = true;
  asio::async_write(reader->socket_, asio::buffer(*line) + sent,
                    [this, reader, line](ErrorCode failed, std::size_t) {
                      if (!reader->connected_) return;
                      reader->busy_ = false;
                      if (failed) Drop(*reader);
                    });
}

void StreamSender::Drop(StreamReader& reader) {
  reader.connected_ = false;
  --readers_;
  ErrorCode ignored;
  reader.socket_.close(ignored);
  const auto entry = std::find_if(connected_.begin(), connected_.end(),
                                  [&](const auto& each) { return each.get() == &reader; });
  if (entry != connected_.end()) connected_.erase(entry);
}

void StreamSender::Close() {
  if (std::exchange(closed_, true)) return;
  if (!own_thread_) return CloseAll();
  if (!thread_.joinable()) return;
  asio::post(io_, [this] { CloseAll(); });
  work_.reset();
  thread_.join();
}

void StreamSender::CloseAll() {
  for (const auto& reader : connected_) {
    reader->connected_ = false;
    --readers_;
    ErrorCode ignored;
    reader->socket_.close(ignored);
  }
  connected_.clear();
}

}  // namespace ccmorse::servers
