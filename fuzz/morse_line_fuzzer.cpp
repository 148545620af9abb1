// LineSplitter and ParseMorseRequest. The input: one byte for the longest line, one for the number
// of cuts, one byte for each cut (how many bytes come and how often Next() is called then), then
// the stream. What must hold:
// - the lines, and the notices of lines that are too long, do not depend on the cuts;
// - no line is beyond the limit or has a line end in it, and never more than the limit stays
//   buffered once all lines were taken;
// - a request's parts lie in its line, in order, without spaces around them, and parse to the same
//   when they are put together again.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/check.h"
#include "wire/morse_line.h"

namespace {

using ccmorse::Json;
using ccmorse::fuzz::Require;
using ccmorse::wire::LineSplitter;
using ccmorse::wire::MorseRequest;

constexpr std::string_view kSpace = " \t\r\n\v\f";

struct Event {
  bool too_long = false;
  std::string line;
  bool operator==(const Event&) const = default;
};

// Calls Next() up to `most` times; true when it wants more bytes.
bool Take(LineSplitter& splitter, std::size_t limit, std::size_t most, std::vector<Event>& events) {
  for (std::size_t i = 0; i < most; ++i) {
    std::string_view line;
    switch (splitter.Next(&line)) {
      case LineSplitter::Result::kLine:
        Require(line.size() <= limit, "a line is within the limit");
        Require(line.find('\n') == std::string_view::npos, "a line has no line end");
        events.push_back({false, std::string(line)});
        break;
      case LineSplitter::Result::kTooLong:
        events.push_back({true, ""});
        break;
      case LineSplitter::Result::kNeedMore:
        Require(splitter.buffered() <= limit, "no more than a line stays buffered");
        return true;
    }
  }
  return false;
}

void CheckPart(std::string_view line, std::string_view part, std::size_t& from, bool token) {
  if (part.empty()) return;
  Require(part.data() >= line.data() && part.data() + part.size() <= line.data() + line.size(),
          "a part of a request lies in its line");
  const auto at = static_cast<std::size_t>(part.data() - line.data());
  Require(at >= from, "the parts of a request are in order");
  from = at + part.size();
  Require(kSpace.find(part.front()) == std::string_view::npos &&
              kSpace.find(part.back()) == std::string_view::npos,
          "a part of a request has no spaces around it");
  if (token) {
    Require(part.find_first_of(kSpace) == std::string_view::npos, "a token has no spaces in it");
  }
}

void CheckRequest(std::string_view line) {
  const MorseRequest request = ccmorse::wire::ParseMorseRequest(line);
  std::size_t from = 0;
  CheckPart(line, request.id, from, true);
  CheckPart(line, request.component, from, true);
  CheckPart(line, request.service, from, true);
  CheckPart(line, request.parameters, from, false);
  switch (request.kind) {
    case MorseRequest::Kind::kCall:
      Require(!request.id.empty() && !request.component.empty() && !request.service.empty(),
              "a call has an id, a component and a service");
      break;
    case MorseRequest::Kind::kCancel:
      Require(!request.id.empty() && request.component == "cancel" && request.service.empty(),
              "a cancel is an id and a word");
      break;
    case MorseRequest::Kind::kMalformed:
      Require(request.service.empty() && request.parameters.empty(),
              "what has a service is a call");
      break;
  }
  std::string joined;
  for (const std::string_view part :
       {request.id, request.component, request.service, request.parameters}) {
    if (!part.empty() && !joined.empty()) joined += ' ';
    joined += part;
  }
  const MorseRequest again = ccmorse::wire::ParseMorseRequest(joined);
  Require(again.kind == request.kind && again.id == request.id &&
              again.component == request.component && again.service == request.service &&
              again.parameters == request.parameters,
          "a request put together again is the same", joined);

  // What a server answers is one line, whatever the request was.
  std::string reply;
  ccmorse::wire::AppendMorseReply(reply, request.id, "FAILED", Json(line));
  Require(reply.find('\n') == reply.size() - 1, "a reply is one line", reply);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const std::size_t limit = data[0];
  const std::size_t cuts = std::min<std::size_t>(data[1], size - 2);
  const std::string bytes(data + 2 + cuts, data + size);

  constexpr std::size_t kAll = static_cast<std::size_t>(-1);
  std::vector<Event> whole;
  LineSplitter uncut(limit);
  uncut.Append(bytes);
  Take(uncut, limit, kAll, whole);

  std::vector<Event> pieces;
  LineSplitter splitter(limit);
  std::string_view rest = bytes;
  for (std::size_t i = 0; i < cuts; ++i) {
    const std::size_t count = std::min<std::size_t>(data[2 + i] % 64, rest.size());
    const std::size_t calls = data[2 + i] / 64;
    // The piece is gone after Append(), as a socket's buffer is.
    splitter.Append(std::string(rest.substr(0, count)));
    rest.remove_prefix(count);
    Take(splitter, limit, calls == 3 ? kAll : calls, pieces);
  }
  splitter.Append(std::string(rest));
  Take(splitter, limit, kAll, pieces);
  Require(pieces == whole, "the lines do not depend on the cuts");

  for (const Event& event : whole) {
    if (!event.too_long) CheckRequest(event.line);
  }
  return 0;
}
