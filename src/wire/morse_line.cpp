#include "wire/morse_line.h"

#include <algorithm>

namespace ccmorse::wire {
namespace {

constexpr std::string_view kSpace = " \t\r\n\v\f";

std::string_view TakeToken(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_of(kSpace), rest.size());
  const std::string_view token = rest.substr(0, end);
  rest.remove_prefix(end);
  rest.remove_prefix(std::min(rest.find_first_not_of(kSpace), rest.size()));
  return token;
}

}  // namespace

MorseRequest ParseMorseRequest(std::string_view line) {
  MorseRequest request;
  line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
  const std::size_t last = line.find_last_not_of(kSpace);
  line = line.substr(0, last == std::string_view::npos ? 0 : last + 1);

  request.id = TakeToken(line);
  request.component = TakeToken(line);
  request.service = TakeToken(line);
  request.parameters = line;
  if (!request.service.empty()) {
    request.kind = MorseRequest::Kind::kCall;
  } else if (request.component == "cancel") {
    request.kind = MorseRequest::Kind::kCancel;
  }
  return request;
}

void AppendMorseReply(std::string& out, std::string_view id, std::string_view status,
                      const Json& value) {
  AppendMorseReplyText(out, id, status, value.IsFalsy() ? std::string() : value.Dump());
}

void AppendMorseReplyText(std::string& out, std::string_view id, std::string_view status,
                          std::string_view json) {
  out += id;
  out += ' ';
  out += status;
  if (!json.empty()) {
    out += ' ';
    out += json;
  }
  out += '\n';
}

void LineSplitter::Append(std::string_view bytes) {
  if (begin_ > 0) {
    buffer_.erase(0, begin_);
    searched_ -= begin_;
    begin_ = 0;
  }
  buffer_ += bytes;
}

LineSplitter::Result LineSplitter::Next(std::string_view* line) {
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched_);
    if (end == std::string::npos) {
      searched_ = buffer_.size();
      if (dropping_ || searched_ - begin_ > longest_) {
        begin_ = searched_;
        const bool first_notice = !dropping_;
        dropping_ = true;
        if (first_notice) return Result::kTooLong;
      }
      return Result::kNeedMore;
    }
    const std::size_t start = begin_;
    begin_ = searched_ = end + 1;
    if (dropping_) {
      dropping_ = false;
      continue;
    }
    if (end - start > longest_) return Result::kTooLong;
    *line = std::string_view(buffer_).substr(start, end - start);
    if (!line->empty() && line->back() == '\r') line->remove_suffix(1);
    return Result::kLine;
  }
}

}  // namespace ccmorse::wire
