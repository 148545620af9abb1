#include "tools/bounded_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace ccmorse::tools {

BoundedLog::BoundedLog(std::string path, std::size_t most)
    : path_(std::move(path)), half_(std::max<std::size_t>(most / 2, 1)) {
  ::unlink(path_.c_str());
}

BoundedLog::~BoundedLog() { Close(); }

void BoundedLog::Add(std::string_view text) {
  total_ += text.size();
  if (written_ < half_) {
    const std::string_view head = text.substr(0, half_ - written_);
    Write(head);
    written_ += head.size();
    text.remove_prefix(head.size());
  }
  // Cut only now and then, so that each byte is moved once or twice at most.
  tail_.append(text.substr(text.size() - std::min(text.size(), half_)));
  if (tail_.size() > 2 * half_) tail_.erase(0, tail_.size() - half_);
}

void BoundedLog::Close() {
  if (tail_.size() > half_) tail_.erase(0, tail_.size() - half_);
  const std::uint64_t missing = total_ - written_ - tail_.size();
  if (missing > 0) Write(fmt::format("\n[... {} bytes left out ...]\n", missing));
  Write(tail_);
  tail_.clear();
  written_ = total_;
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

void BoundedLog::Write(std::string_view text) {
  if (text.empty()) return;
  if (file_ < 0) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
  }
  while (!text.empty()) {
    const ssize_t size = ::write(file_, text.data(), text.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(size));
  }
}

}  // namespace ccmorse::tools
