// The fast link's bytes on both sides. The input: one byte for the longest payload (in units of 16
// bytes), one for the number of cuts, one byte for each cut, then the stream. What must hold:
// - the frames, and where they end, do not depend on the cuts;
// - a frame is within the limit, and once all were taken less than one stays buffered;
// - what parses is within its limits and lies in the frame;
// - an image that the code gives is the same when it is coded again.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/check.h"
#include "wire/canvas_code.h"
#include "wire/fast_link.h"

namespace {

namespace wire = ccmorse::wire;
using ccmorse::fuzz::Require;
using wire::FrameSplitter;

struct Event {
  bool broken = false;
  wire::FrameType type = wire::FrameType::kLines;
  std::string payload;
  bool operator==(const Event&) const = default;
};

void TakeAll(FrameSplitter& splitter, std::size_t longest, std::vector<Event>& events) {
  if (!events.empty() && events.back().broken) return;
  wire::Frame frame;
  for (;;) {
    switch (splitter.Next(&frame)) {
      case FrameSplitter::Result::kFrame:
        Require(frame.payload.size() <= longest, "a frame is within the limit");
        events.push_back({false, frame.type, std::string(frame.payload)});
        break;
      case FrameSplitter::Result::kBroken:
        events.push_back({true, wire::FrameType::kLines, ""});
        return;
      case FrameSplitter::Result::kNeedMore:
        Require(splitter.buffered() < wire::kFrameHeader + longest, "less than a frame stays");
        return;
    }
  }
}

bool LiesIn(std::string_view part, std::string_view whole) {
  return part.empty() ||
         (part.data() >= whole.data() && part.data() + part.size() <= whole.data() + whole.size());
}

void CheckImage(std::string_view payload) {
  wire::ByteReader reader(payload);
  reader.Short();
  const int width = reader.Short() % 64;
  const int height = reader.Short() % 64;
  const std::size_t bytes =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * wire::kCellBytes;
  std::vector<std::uint8_t> image(bytes, 0);
  if (!wire::ApplyChanges(reader.rest(), image, width, height)) return;
  Require(image.size() == bytes, "an image keeps its size");
  const std::vector<std::uint8_t> base(bytes, 0);
  std::string code;
  wire::AppendChanges(code, base.data(), image.data(), width, height);
  std::vector<std::uint8_t> again = base;
  Require(wire::ApplyChanges(code, again, width, height) && again == image,
          "an image coded again is the same");
}

void CheckPixels(std::string_view payload) {
  wire::ByteReader reader(payload);
  reader.Short();
  std::string plain;
  const bool fine = wire::ExpandRectangles(reader.rest(), &plain);
  Require(plain.size() <= wire::kMostCells * wire::kCellBytes + 12 * (payload.size() / 12 + 1),
          "pixels are within the limit");
  if (!fine) return;
  wire::ByteReader rectangles(plain);
  std::string code;
  while (!rectangles.rest().empty()) {
    const auto x = static_cast<std::int32_t>(rectangles.Long());
    const auto y = static_cast<std::int32_t>(rectangles.Long());
    const int width = rectangles.Short();
    const int height = rectangles.Short();
    const std::string_view cells = rectangles.Bytes(
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * wire::kCellBytes);
    Require(rectangles.ok(), "rectangles are whole");
    wire::AppendRectangle(code, x, y, width, height,
                          reinterpret_cast<const std::uint8_t*>(cells.data()));
  }
  std::string again;
  Require(wire::ExpandRectangles(code, &again) && again == plain,
          "rectangles coded again are the same");
}

void CheckFrame(wire::FrameType type, std::string_view payload) {
  switch (type) {
    case wire::FrameType::kCommand: {
      wire::CommandMessage message;
      if (wire::ParseCommand(payload, &message)) {
        Require(message.count <= wire::kMostNumbers && payload.size() == 2 + 8 * message.count,
                "a command's numbers are all of its payload");
      }
      break;
    }
    case wire::FrameType::kDeclare: {
      wire::DeclareMessage message;
      if (wire::ParseDeclare(payload, &message)) {
        Require(message.id < wire::kMostDeclared && LiesIn(message.component, payload) &&
                    LiesIn(message.service, payload) &&
                    message.component.size() + message.service.size() + 4 == payload.size(),
                "a declaration's names are all of its payload");
      }
      break;
    }
    case wire::FrameType::kSubscribe: {
      wire::SubscribeMessage message;
      if (wire::ParseSubscribe(payload, &message)) {
        Require(message.id < wire::kMostDeclared && LiesIn(message.device, payload),
                "a subscription's name lies in its payload");
      }
      break;
    }
    case wire::FrameType::kImage:
      CheckImage(payload);
      break;
    case wire::FrameType::kPixels:
      CheckPixels(payload);
      break;
    case wire::FrameType::kData: {
      wire::ByteReader reader(payload);
      reader.Double();
      wire::DataEntry entry;
      while (wire::NextDataEntry(reader, &entry)) {
        Require(LiesIn(entry.bytes, payload), "data lie in their payload");
        std::vector<double> numbers(entry.bytes.size() / sizeof(double));
        wire::CopyDoubles(entry.bytes.data(), numbers.size(), numbers.data());
      }
      break;
    }
    default:
      break;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const std::size_t longest = std::size_t{data[0]} * 16;
  const std::size_t cuts = std::min<std::size_t>(data[1], size - 2);
  const std::string bytes(data + 2 + cuts, data + size);

  std::vector<Event> whole;
  FrameSplitter uncut(longest);
  uncut.Append(bytes);
  TakeAll(uncut, longest, whole);

  std::vector<Event> pieces;
  FrameSplitter splitter(longest);
  std::string_view rest = bytes;
  for (std::size_t i = 0; i < cuts; ++i) {
    const std::size_t count = std::min<std::size_t>(data[2 + i], rest.size());
    splitter.Append(std::string(rest.substr(0, count)));
    rest.remove_prefix(count);
    TakeAll(splitter, longest, pieces);
  }
  splitter.Append(std::string(rest));
  TakeAll(splitter, longest, pieces);
  Require(pieces == whole, "the frames do not depend on the cuts");

  for (const Event& event : whole) {
    if (!event.broken) CheckFrame(event.type, event.payload);
  }
  return 0;
}
