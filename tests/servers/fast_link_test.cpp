// The fast link from the outside: bytes over a socket, as docs/protocols/fast-link.md has them.

#include "wire/fast_link.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <vector>

#include "base/json.h"
#include "base/log.h"
#include "tests/servers/served_simulation.h"
#include "tests/support/line_client.h"
#include "wire/canvas_code.h"

namespace ccmorse::servers {
namespace {

using testing::LineClient;
using wire::DataForm;
using wire::FrameType;
using wire::FrameWriter;

/// A client that has gone over to frames.
class FrameClient {
 public:
  explicit FrameClient(int port) : client_(port) {
    EXPECT_EQ(client_.Ask("1 ccmorse fast_link [1]"), "1 SUCCESS 1");
  }

  struct Received {
    FrameType type = FrameType::kLines;
    std::string payload;
  };

  void Send(std::string_view bytes) { client_.Send(bytes); }

  Received Next(std::chrono::milliseconds timeout = std::chrono::milliseconds(10000)) {
    const auto header = client_.ReadBytes(wire::kFrameHeader, timeout);
    if (!header) return {FrameType::kLines, "nothing came"};
    wire::ByteReader reader(*header);
    const std::uint32_t size = reader.Long();
    Received received{static_cast<FrameType>(reader.Byte()), ""};
    received.payload = client_.ReadBytes(size).value_or("cut short");
    return received;
  }

  /// Sends a line and gives the line that comes back.
  std::string Ask(const std::string& line) {
    Send(Lines(line + "\n"));
    const Received reply = Next();
    EXPECT_EQ(reply.type, FrameType::kLines);
    return reply.payload;
  }

  static std::string Frame(FrameType type, std::string_view payload) {
    std::string out;
    FrameWriter(out, type).Bytes(payload);
    return out;
  }
  static std::string Lines(std::string_view lines) { return Frame(FrameType::kLines, lines); }
  static std::string Read() { return Frame(FrameType::kRead, ""); }

  LineClient& raw() { return client_; }

 private:
  LineClient client_;
};

std::string Declare(int id, std::string_view component, std::string_view service) {
  std::string out;
  {
    FrameWriter frame(out, FrameType::kDeclare);
    frame.Short(static_cast<std::uint16_t>(id));
    frame.Short(static_cast<std::uint16_t>(component.size()));
    frame.Bytes(component);
    frame.Bytes(service);
  }
  return out;
}

std::string Command(int id, const std::vector<double>& numbers) {
  std::string out;
  {
    FrameWriter frame(out, FrameType::kCommand);
    frame.Short(static_cast<std::uint16_t>(id));
    frame.Doubles(numbers.data(), numbers.size());
  }
  return out;
}

std::string Subscribe(int id, DataForm form, std::string_view device) {
  std::string out;
  {
    FrameWriter frame(out, FrameType::kSubscribe);
    frame.Short(static_cast<std::uint16_t>(id));
    frame.Byte(static_cast<std::uint8_t>(form));
    frame.Bytes(device);
  }
  return out;
}

struct Entry {
  DataForm form = DataForm::kText;
  double timestamp = 0.0;
  std::string text;
  std::vector<double> numbers;
};
struct Data {
  double time = -1.0;
  std::map<int, Entry> entries;
};

Data DataOf(const FrameClient::Received& received) {
  EXPECT_EQ(received.type, FrameType::kData) << received.payload;
  Data data;
  wire::ByteReader reader(received.payload);
  data.time = reader.Double();
  wire::DataEntry entry;
  while (wire::NextDataEntry(reader, &entry)) {
    Entry& taken = data.entries[entry.id];
    taken.form = entry.form;
    taken.timestamp = entry.timestamp;
    if (entry.form == DataForm::kText) {
      taken.text = entry.bytes;
    } else {
      taken.numbers.resize(entry.bytes.size() / sizeof(double));
      wire::CopyDoubles(entry.bytes.data(), taken.numbers.size(), taken.numbers.data());
    }
  }
  EXPECT_TRUE(reader.ok());
  return data;
}

double At(const Json& data, const char* key) {
  const Json* value = data.Find(key);
  return value->IsBool() ? (value->AsBool() ? 1.0 : 0.0) : value->AsDouble();
}

class QuietTest : public ::testing::Test {
 protected:
  QuietTest() { SetLogLevel(LogLevel::kError); }
  ~QuietTest() override { SetLogLevel(LogLevel::kInfo); }
};
using N05 = QuietTest;

TEST_F(N05, HelloOffersItAndOtherVersionsAreTurnedDown) {
  ServedSimulation served("{}");
  LineClient client(served.port());
  EXPECT_NE(client.Ask("1 ccmorse hello []").find("\"fast_link\": 1"), std::string::npos);
  for (const char* version : {"[2]", "[0]", "[]", "", "[\"1\"]", "[1, 1]", "1", "["}) {
    const std::string reply = client.Ask(std::string("2 ccmorse fast_link ") + version);
    EXPECT_EQ(reply, "2 FAILED \"This server's fast link has version 1 only\"") << version;
  }
  EXPECT_EQ(client.Ask("3 ccmorse ping"), "3 SUCCESS \"pong\"");  // lines still
  EXPECT_EQ(client.Ask("4 ccmorse fast_link [1]"), "4 SUCCESS 1");
  client.Send(FrameClient::Lines("5 ccmorse fast_link [1]\n"));
  client.ReadBytes(wire::kFrameHeader);
  EXPECT_EQ(client.ReadLine(), "5 FAILED \"This is a fast link already\"");
}

TEST_F(N05, NumbersAreTheOnesOfTheText) {
  ServedSimulation served("{}", Pace::kLockstep);
  FrameClient client(served.port());
  client.Send(Declare(7, "s1r.motion", "set_speed") + Subscribe(0, DataForm::kPose, "s1r.pose") +
              Subscribe(1, DataForm::kOdometry, "s1r.odometry") +
              Subscribe(2, DataForm::kScan, "s1r.hokuyo") +
              Subscribe(3, DataForm::kText, "s1r.properties"));
  for (int i = 0; i < 30; ++i) {
    client.Send(Command(7, {0.2, 0.3 - 0.1 * (i % 7)}) + FrameClient::Read());
    const Data data = DataOf(client.Next());
    ASSERT_EQ(data.entries.size(), 4U);
    const auto text = [&](const std::string& device) {
      std::string reply = client.Ask("1 " + device + " get_local_data");
      return Json::Parse(reply.substr(reply.find('{')));
    };
    const Json pose = text("s1r.pose");
    EXPECT_EQ(data.entries.at(0).numbers,
              (std::vector<double>{At(pose, "x"), At(pose, "y"), At(pose, "z"), At(pose, "roll"),
                                   At(pose, "pitch"), At(pose, "yaw")}));
    EXPECT_EQ(data.entries.at(0).timestamp, At(pose, "timestamp"));
    const Json odometry = text("s1r.odometry");
    std::vector<double> expected;
    for (const char* key :
         {"x", "y", "z", "roll", "pitch", "yaw", "vx", "vy", "vz", "wx", "wy", "wz", "stall"}) {
      expected.push_back(At(odometry, key));
    }
    EXPECT_EQ(data.entries.at(1).numbers, expected);
    const Json scan = text("s1r.hokuyo");
    expected.clear();
    for (const Json& range : scan.Find("range_list")->AsArray()) {
      expected.push_back(range.AsDouble());
    }
    EXPECT_EQ(data.entries.at(2).numbers, expected);
    EXPECT_EQ(data.entries.at(2).timestamp, At(scan, "timestamp"));
    EXPECT_EQ(Json::Parse(data.entries.at(3).text), text("s1r.properties"));
    EXPECT_NEAR(data.time, 0.1 * i, 1e-12);
  }
}

TEST_F(N05, OnlyWhatIsSubscribedComes) {
  ServedSimulation served("{}", Pace::kLockstep);
  FrameClient client(served.port());
  const auto read = [&](const std::string& changes) {
    client.Send(changes + FrameClient::Read());
    return DataOf(client.Next()).entries;
  };
  EXPECT_TRUE(read("").empty());
  EXPECT_EQ(read(Subscribe(5, DataForm::kPose, "s1r.pose")).size(), 1U);
  // A device has one number: the newest.
  const auto twice = read(Subscribe(6, DataForm::kText, "s1r.pose"));
  EXPECT_EQ(twice.size(), 1U);
  EXPECT_EQ(twice.count(6), 1U);
  // What has no data, and what there is not, is left out; a form that does not fit is text.
  EXPECT_EQ(
      read(Subscribe(1, DataForm::kText, "s1r.motion") + Subscribe(2, DataForm::kScan, "nobody"))
          .size(),
      1U);
  EXPECT_EQ(read(Subscribe(3, DataForm::kPose, "s1r.hokuyo")).at(3).form, DataForm::kText);
  EXPECT_EQ(read(Subscribe(6, DataForm::kNone, "")).size(), 1U);
  EXPECT_EQ(read(Subscribe(3, DataForm::kNone, "s1r.hokuyo")).size(), 0U);
}

TEST_F(N05, ARefusedCommandIsTold) {
  ServedSimulation served("{}", Pace::kLockstep);
  FrameClient client(served.port());
  client.Send(Declare(0, "s1r.motion", "set_speed") + Declare(1, "s1r.motion", "fly"));
  const auto refusal = [&](const std::string& frames) {
    client.Send(frames);
    const auto received = client.Next();
    EXPECT_EQ(received.type, FrameType::kRefused);
    wire::ByteReader reader(received.payload);
    const int id = reader.Short();
    return std::to_string(id) + " " + std::string(reader.rest());
  };
  EXPECT_EQ(refusal(Command(0, {std::numeric_limits<double>::quiet_NaN(), 0.0})),
            "0 \"Socket service manager: wrong parameter type for service set_speed. v must be "
            "finite, not NaN\"");
  EXPECT_NE(refusal(Command(0, {1.0})).find("missing 1 required positional argument: 'w'"),
            std::string::npos);
  EXPECT_EQ(refusal(Command(1, {})),
            "1 \"The request fly has not been registered in Socket service manager\"");
  // A service that takes its time is told of when it ends.
  client.Send(Declare(2, "s1r.waypoint", "goto") + Command(2, {1.0, 1.0, 0.0}));
  EXPECT_EQ(refusal(Command(2, {1.0, 1.0, 0.0})).substr(0, 1), "2");
  EXPECT_EQ(client.Ask("9 ccmorse ping"), "9 SUCCESS \"pong\"\n");
}

TEST_F(N05, RequestsBehindAReadWaitButPingsDoNot) {
  ServedSimulation served("{}", Pace::kLockstep, 0.0, {}, 2);
  FrameClient client(served.port());
  client.Send(FrameClient::Read());
  DataOf(client.Next());
  client.Send(FrameClient::Read() + FrameClient::Lines("1 time now\n") +
              Declare(0, "s1r.motion", "set_speed") + Command(0, {}) +
              FrameClient::Lines("2 ccmorse ping\n3 time mode\n"));
  EXPECT_EQ(client.Next().payload, "2 SUCCESS \"pong\"\n");
  EXPECT_EQ(client.Next(std::chrono::milliseconds(100)).payload, "nothing came");
  LineClient other(served.port());
  other.Send("1 ccmorse read\n2 ccmorse read\n");
  EXPECT_NEAR(DataOf(client.Next()).time, 0.1, 1e-12);
  EXPECT_EQ(client.Next().payload, "1 SUCCESS 0.1\n");
  EXPECT_EQ(client.Next().type, FrameType::kRefused);
  EXPECT_EQ(client.Next().payload, "3 SUCCESS \"Fixed Simulation Step\"\n");
}

TEST_F(N05, LinesAndFramesOfAReadAreTheSameRead) {
  ServedSimulation served("{}", Pace::kLockstep);
  FrameClient client(served.port());
  client.Send(FrameClient::Read());
  EXPECT_EQ(DataOf(client.Next()).time, 0.0);
  EXPECT_EQ(client.Ask("1 ccmorse read"), "1 SUCCESS {\"time\": 0.1}\n");
  client.Send(FrameClient::Read());
  EXPECT_NEAR(DataOf(client.Next()).time, 0.2, 1e-12);
}

TEST_F(N05, TheEndIsTold) {
  ServedSimulation served("{}", Pace::kLockstep, 0.2);
  FrameClient client(served.port());
  for (int i = 0; i < 2; ++i) {
    client.Send(FrameClient::Read());
    DataOf(client.Next());
  }
  client.Send(FrameClient::Read());
  const auto end = client.Next();
  EXPECT_EQ(end.type, FrameType::kReadFailed);
  EXPECT_EQ(end.payload, "\"The simulation has ended at 0.200 s\"");
}

std::string Image(int service, int width, int height, const std::vector<std::uint8_t>& base,
                  const std::vector<std::uint8_t>& image) {
  std::string out;
  {
    FrameWriter frame(out, FrameType::kImage);
    frame.Short(static_cast<std::uint16_t>(service));
    frame.Short(static_cast<std::uint16_t>(width));
    frame.Short(static_cast<std::uint16_t>(height));
    wire::AppendChanges(out, base.data(), image.data(), width, height);
  }
  return out;
}

TEST_F(N05, AnImageIsTheWholeCanvasWhateverOthersDrew) {
  ServedSimulation served("{}", Pace::kLockstep);
  FrameClient client(served.port());
  EXPECT_EQ(client.Ask("1 s1r.pen resize_canvas [3, 2]"), "1 SUCCESS\n");
  const std::vector<std::uint8_t> black(18, 0);
  std::vector<std::uint8_t> image(18);
  for (std::size_t i = 0; i < 18; ++i) image[i] = static_cast<std::uint8_t>(10 + i);
  client.Send(Declare(0, "s1r.pen", "set_image_data") + Image(0, 3, 2, black, image));
  const std::string drawn =
      "2 SUCCESS [[10, 11, 12], [13, 14, 15], [16, 17, 18], [19, 20, 21], [22, 23, 24], "
      "[25, 26, 27]]\n";
  EXPECT_EQ(client.Ask("2 s1r.pen get_image_data"), drawn);
  LineClient other(served.port());
  EXPECT_EQ(other.Ask("1 s1r.pen set_pixel [1, 1, 0, 0, 0]"), "1 SUCCESS");
  // Nothing has changed in what this client sends, and still the canvas is what it says.
  client.Send(Image(0, 3, 2, image, image));
  EXPECT_EQ(client.Ask("2 s1r.pen get_image_data"), drawn);
  // Another size is refused as in lines, and does not confuse what follows.
  client.Send(Image(0, 2, 2, std::vector<std::uint8_t>(12, 0), std::vector<std::uint8_t>(12, 9)));
  const auto refused = client.Next();
  EXPECT_EQ(refused.type, FrameType::kRefused);
  EXPECT_NE(refused.payload.find("the canvas has 6 cells, but 4 pixels came"), std::string::npos);
  client.Send(Image(0, 3, 2, black, image));
  EXPECT_EQ(client.Ask("2 s1r.pen get_image_data"), drawn);
}

TEST_F(N05, PixelsOutsideTheCanvasAreLeftOut) {
  ServedSimulation served("{}", Pace::kLockstep);
  FrameClient client(served.port());
  EXPECT_EQ(client.Ask("1 s1r.pen resize_canvas [2, 2]"), "1 SUCCESS\n");
  std::string code(2, '\0');
  const std::vector<std::uint8_t> red{255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0};
  wire::AppendRectangle(code, -1, -1, 2, 2, red.data());
  wire::AppendRectangle(code, 1, 1, 2, 2, red.data());
  wire::AppendRectangle(code, 1000000000, -1000000000, 2, 2, red.data());
  client.Send(Declare(0, "s1r.pen", "update_image_data") +
              FrameClient::Frame(FrameType::kPixels, code));
  EXPECT_EQ(client.Ask("2 s1r.pen get_image_data"),
            "2 SUCCESS [[255, 0, 0], [255, 255, 255], [255, 255, 255], [255, 0, 0]]\n");
  // A service that takes no such thing says so.
  client.Send(Declare(1, "s1r.motion", "set_speed") +
              FrameClient::Frame(FrameType::kPixels, std::string("\1\0", 2) + code.substr(2)));
  EXPECT_EQ(client.Next().type, FrameType::kRefused);
}

TEST_F(N05, WhatIsNoFrameEndsThisConnectionOnly) {
  ServedSimulation served("{}", Pace::kLockstep);
  LineClient other(served.port());
  const std::string declared = Declare(0, "s1r.pen", "set_image_data");
  const std::string huge(std::string("\0\0", 2) + "\xFF\xFF\xFF\xFF");  // 65535 x 65535
  for (const std::string& bytes :
       {std::string("1 simulation list_robots\n"), std::string("\xFF\xFF\xFF\xFF\1\0\0\0", 8),
        FrameClient::Frame(FrameType::kData, ""), FrameClient::Frame(FrameType::kRead, "x"),
        FrameClient::Frame(FrameType::kCommand, ""), Command(3, {1.0}), declared + declared,
        declared + FrameClient::Frame(FrameType::kImage, ""),
        declared + FrameClient::Frame(FrameType::kImage, huge),
        declared + FrameClient::Frame(FrameType::kPixels, std::string("\0\0junk", 6)),
        FrameClient::Frame(FrameType::kSubscribe, "x")}) {
    FrameClient client(served.port());
    client.Send(bytes);
    EXPECT_TRUE(client.raw().IsClosed());
    EXPECT_EQ(other.Ask("1 ccmorse ping"), "1 SUCCESS \"pong\"");
  }
  // The same behind a read that waits.
  FrameClient waiting(served.port());
  waiting.Send(FrameClient::Read() + FrameClient::Read() +
               FrameClient::Frame(FrameType::kData, ""));
  EXPECT_EQ(waiting.Next().type, FrameType::kData);
  FrameClient another(served.port());
  another.Send(FrameClient::Read() + "garbage, not a frame");
  EXPECT_TRUE(another.raw().IsClosed());
  EXPECT_EQ(other.Ask("1 ccmorse ping"), "1 SUCCESS \"pong\"");
}

TEST_F(N05, FramesMayComeByteByByte) {
  ServedSimulation served("{}", Pace::kLockstep);
  FrameClient client(served.port());
  const std::string bytes = Declare(0, "s1r.motion", "set_speed") + Command(0, {0.1, 0.0}) +
                            Subscribe(0, DataForm::kPose, "s1r.pose") + FrameClient::Read();
  for (const char byte : bytes) client.Send(std::string(1, byte));
  EXPECT_EQ(DataOf(client.Next()).entries.size(), 1U);
}

}  // namespace
}  // namespace ccmorse::servers
