// The fast link as the client sees it: it falls back silently, and survives a server gone mad.

#include "client/core/fast_link.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "tests/client/client_fixture.h"
#include "wire/canvas_code.h"
#include "wire/fast_link.h"

namespace ccmorse::test {
namespace {

using namespace CCMorse;
using wire::FrameType;
using wire::FrameWriter;

constexpr char kHello[] =
    R"(SUCCESS {"server": "ccmorse 0.1.0", "protocol": 1, "fast_link": 1, "pace": "lockstep", )"
    R"("frequency": 60.0, "read_period": 0.1})";

TEST(N05, WithoutTheFastLinkTheClientSpeaksJson) {
  FakeServer morse(Plain());
  EXPECT_EQ(MorseClient::Share(kHost, morse.port())->GetLink(), "json");
  FakeServer older;  // a ccmorse that has never heard of it
  const auto client = MorseClient::Share(kHost, older.port());
  EXPECT_EQ(client->GetLink(), "json");
  EXPECT_EQ(older.Count("ccmorse fast_link"), 0U);
  client->Read();
  EXPECT_EQ(older.Count("s1r.hokuyo get_local_data"), 1U);
}

TEST(N05, AnotherVersionOfTheFastLinkMeansJson) {
  FakeServer server;
  std::string hello = kHello;
  hello.replace(hello.find("\"fast_link\": 1"), 14, "\"fast_link\": 2");
  server.Answer("ccmorse hello", hello);
  EXPECT_EQ(MorseClient::Share(kHost, server.port())->GetLink(), "json");
  EXPECT_EQ(server.Count("ccmorse fast_link"), 0U);
}

TEST(N05, AServerThatChangesItsMindIsSpokenToInJson) {
  FakeServer server;
  server.Answer("ccmorse hello", kHello);
  server.Answer("ccmorse fast_link", "FAILED \"not today\"");
  const auto client = MorseClient::Share(kHost, server.port());
  EXPECT_EQ(client->GetLink(), "json");
  EXPECT_EQ(server.Count("ccmorse fast_link [1]"), 1U);
  client->Read();
  EXPECT_TRUE(client->GetRobot("s1r").GetDevice("hokuyo").HasData());
}

// A client whose server has agreed to the fast link and sends `bytes` as soon as a frame comes.
class Mad {
 public:
  explicit Mad(const std::string& bytes) {
    server_.Answer("ccmorse hello", kHello);
    server_.Answer("ccmorse fast_link", "SUCCESS 1");
    client_ = MorseClient::Share(kHost, server_.port());
    EXPECT_EQ(client_->GetLink(), "fast");
    server_.SendRaw(bytes);
  }
  MorseClient& client() { return *client_; }

 private:
  FakeServer server_;
  std::shared_ptr<MorseClient> client_;
};

TEST(N05, WhatIsNoFrameIsAnError) {
  for (const std::string& bytes :
       {std::string("17 SUCCESS \"lines still\"\n"), std::string("\xFF\xFF\xFF\xFF\x8\0\0\0", 8),
        std::string("\0\0\0\0\x63\0\0\0", 8)}) {
    Mad mad(bytes);
    const MorseError error = ErrorOf([&] { mad.client().Read(); });
    EXPECT_TRUE(Has(error.GetErrorStr(), "no frame of the fast link"));
    EXPECT_FALSE(mad.client().Connected());
  }
}

std::string Data(double time, const std::function<void(FrameWriter&)>& entries) {
  std::string out;
  {
    FrameWriter frame(out, FrameType::kData);
    frame.Double(time);
    entries(frame);
  }
  return out;
}

void Entry(FrameWriter& frame, int id, int form, std::size_t size, double timestamp,
           std::string_view bytes) {
  frame.Short(static_cast<std::uint16_t>(id));
  frame.Byte(static_cast<std::uint8_t>(form));
  frame.Long(static_cast<std::uint32_t>(size));
  frame.Double(timestamp);
  frame.Bytes(bytes);
}

// Reads once; a line that goes with the read tells the server when to answer it.
void ReadFrom(FakeServer& server, MorseClient& client, const std::string& data) {
  server.Answer("now please", std::nullopt);
  server.OnLine([&server, data](const std::string& line) {
    if (line == "now please") server.SendRaw(data);
  });
  client.Command("now", "please");
  client.Read();
  server.OnLine(nullptr);
}

TEST(N05, DataThatMakeNoSenseAreNotTaken) {
  FakeServer server;
  server.Answer("ccmorse hello", kHello);
  server.Answer("ccmorse fast_link", "SUCCESS 1");
  const auto client = MorseClient::Share(kHost, server.port());
  const std::vector<MorseDevice*> devices = client->GetDevices();
  int pose = -1;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    if (devices[i]->GetName() == "s1r.pose") pose = static_cast<int>(i);
  }
  ASSERT_GE(pose, 0);
  auto& device = client->GetRobot("s1r").GetDevice<MorsePose>();
  const std::string six(48, '\0');
  const auto good = [&](FrameWriter& frame) { Entry(frame, pose, 1, 48, 1.0, six); };
  ReadFrom(server, *client, Data(1.0, good));
  EXPECT_TRUE(device.IsValid());
  EXPECT_EQ(client->GetTime(), 1.0);
  // Five numbers, not a number, an unknown device and form, a size beyond the end.
  std::string nan(48, '\0');
  nan[7] = '\x7F';
  nan[6] = '\xF8';
  for (const std::string& bytes :
       {Data(2.0, [&](FrameWriter& f) { Entry(f, pose, 1, 40, 2.0, six.substr(0, 40)); }),
        Data(2.0, [&](FrameWriter& f) { Entry(f, pose, 1, 48, 2.0, nan); })}) {
    ReadFrom(server, *client, Data(1.0, good));
    EXPECT_TRUE(device.IsValid());
    ReadFrom(server, *client, bytes);
    EXPECT_FALSE(device.IsValid());
    EXPECT_EQ(device.GetTimestamp(), 1.0);
  }
  ReadFrom(server, *client, Data(1.0, good));
  for (const std::string& bytes :
       {Data(3.0, [&](FrameWriter& f) { Entry(f, 4000, 1, 48, 3.0, six); }),
        Data(3.0, [&](FrameWriter& f) { Entry(f, pose, 77, 48, 3.0, six); }),
        Data(3.0, [&](FrameWriter& f) { Entry(f, pose, 1, 4000000000U, 3.0, six); }),
        Data(3.0, [&](FrameWriter& f) { Entry(f, pose, 0, 5, 3.0, "[1, 2"); }),
        Data(3.0, [&](FrameWriter& f) { f.Bytes("xyz"); })}) {
    ReadFrom(server, *client, bytes);
    EXPECT_TRUE(device.IsValid());
    EXPECT_EQ(device.GetTimestamp(), 1.0);
  }
}

// --- What the client writes.

// Frames of `bytes`, each as type and payload.
std::vector<std::pair<FrameType, std::string>> Frames(const std::string& bytes) {
  wire::FrameSplitter splitter(wire::kMostClientFrame);
  splitter.Append(bytes);
  std::vector<std::pair<FrameType, std::string>> frames;
  wire::Frame frame;
  while (splitter.Next(&frame) == wire::FrameSplitter::Result::kFrame) {
    frames.emplace_back(frame.type, frame.payload);
  }
  EXPECT_EQ(splitter.buffered(), 0U);
  return frames;
}

TEST(N05, AServiceIsDeclaredOnce) {
  core::FastLinkWriter writer;
  std::string out;
  const double numbers[] = {0.1, 0.2};
  EXPECT_TRUE(writer.Command(out, "s1r.motion", "set_speed", numbers, 2));
  EXPECT_TRUE(writer.Command(out, "s1r.motion", "set_speed", numbers, 2));
  EXPECT_TRUE(writer.Command(out, "s1r.motion", "stop", nullptr, 0));
  const auto frames = Frames(out);
  ASSERT_EQ(frames.size(), 5U);
  EXPECT_EQ(frames[0].first, FrameType::kDeclare);
  EXPECT_EQ(frames[1].first, FrameType::kCommand);
  EXPECT_EQ(frames[2], frames[1]);
  EXPECT_EQ(frames[3].first, FrameType::kDeclare);
  EXPECT_EQ(writer.ServiceOf(1)->second, "stop");
  EXPECT_EQ(writer.ServiceOf(2), nullptr);
}

TEST(N05, TheExampleOfTheDocumentation) {
  core::FastLinkWriter writer;
  std::string out;
  const double speed[] = {0.5, -1.0};
  const std::string pose = "s1r.pose";
  EXPECT_TRUE(writer.Command(out, "s1r.motion", "set_speed", speed, 2));
  writer.Read(out, {{0, wire::DataForm::kPose, &pose}});
  const char expected[] =
      "\x17\0\0\0\x03\0\0\0\0\0\x0A\0s1r.motionset_speed"
      "\x12\0\0\0\x02\0\0\0\0\0\0\0\0\0\0\0\xE0\x3F\0\0\0\0\0\0\xF0\xBF"
      "\x0B\0\0\0\x04\0\0\0\0\0\x01s1r.pose"
      "\0\0\0\0\x05\0\0";  // and the zero that ends the literal
  EXPECT_EQ(out, std::string(expected, sizeof expected));
  EXPECT_EQ(out.size(), 84U);
}

TEST(N05, WhatHasNoFrameIsLeftToLines) {
  core::FastLinkWriter writer;
  std::string out;
  const std::vector<double> many(wire::kMostNumbers + 1);
  EXPECT_FALSE(writer.Command(out, "a", "b", many.data(), many.size()));
  EXPECT_FALSE(writer.Image(out, "a", "b", 0, 0, {}));
  EXPECT_FALSE(writer.Image(out, "a", "b", 2, 2, std::vector<Color_t>(3)));
  EXPECT_FALSE(writer.Image(out, "a", "b", 2000, 2000, std::vector<Color_t>(4000000)));
  EXPECT_EQ(out, "");
}

TEST(N05, PixelsKeepTheirPlaceAmongCommandsAndFitIntoFrames) {
  core::FastLinkWriter writer;
  std::string out;
  std::vector<PixelUpdate_t> pixels;
  for (int i = 0; i < 200000; ++i) {  // scattered: each is a rectangle of its own
    pixels.push_back({{7 * i, -3 * i}, {1, 2, 3}});
  }
  EXPECT_TRUE(writer.Pixels(out, "s1r.pen", "update_image_data", pixels.data(), pixels.size()));
  EXPECT_TRUE(writer.Command(out, "s1r.motion", "stop", nullptr, 0));
  EXPECT_TRUE(writer.Pixels(out, "s1r.pen", "update_image_data", pixels.data(), 1));
  writer.Lines(out, "1 time now\n");
  std::size_t cells = 0;
  std::vector<FrameType> order;
  for (const auto& [type, payload] : Frames(out)) {
    if (type == FrameType::kDeclare) continue;
    if (order.empty() || order.back() != type) order.push_back(type);
    if (type != FrameType::kPixels) continue;
    std::string plain;
    ASSERT_TRUE(wire::ExpandRectangles(std::string_view(payload).substr(2), &plain));
    cells += plain.size() / 15;
  }
  EXPECT_EQ(order, (std::vector<FrameType>{FrameType::kPixels, FrameType::kCommand,
                                           FrameType::kPixels, FrameType::kLines}));
  EXPECT_EQ(cells, 200001U);
}

}  // namespace
}  // namespace ccmorse::test
