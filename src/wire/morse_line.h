#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/json.h"

namespace ccmorse::wire {

/// A request line of MORSE's service port: `id component service [json]` or `id cancel`
/// (specs: morse.md A.5). The views point into the line it was parsed from.
struct MorseRequest {
  enum class Kind { kCall, kCancel, kMalformed };
  Kind kind = Kind::kMalformed;
  std::string_view id;  ///< empty for a blank line
  std::string_view component;
  std::string_view service;
  std::string_view parameters;  ///< raw JSON text; empty when there is none
};

/// Any bytes will do: what is no request comes back as kMalformed, with the id if there is one.
MorseRequest ParseMorseRequest(std::string_view line);

/// Appends `id STATUS` or `id STATUS json` and a line end. Falsy results are not written, as MORSE
/// leaves them out.
void AppendMorseReply(std::string& out, std::string_view id, std::string_view status,
                      const Json& value);
/// The same with a result that is JSON text already.
void AppendMorseReplyText(std::string& out, std::string_view id, std::string_view status,
                          std::string_view json);

/// Cuts a stream of bytes into lines, with a limit on their length.
class LineSplitter {
 public:
  explicit LineSplitter(std::size_t longest) : longest_(longest) {}

  void Append(std::string_view bytes);

  enum class Result { kLine, kTooLong, kNeedMore };
  /// kLine: `line` is the next one, without its end ("\n" or "\r\n"), valid until Append() or
  /// Next(). kTooLong: a line beyond the limit has begun; it is dropped up to its end and told of
  /// once.
  Result Next(std::string_view* line);

  std::size_t buffered() const { return buffer_.size() - begin_; }

 private:
  std::size_t longest_;
  std::string buffer_;
  std::size_t begin_ = 0;     // of what was not handed out yet
  std::size_t searched_ = 0;  // no line end before here
  bool dropping_ = false;
};

}  // namespace ccmorse::wire
