// Player's messages on the wire, byte for byte as libtirpc's XDR routines, which are not ours, pack
// the same fields (specs: player.md B.2, B.3; RFC 4506).

#include <gtest/gtest.h>
#include <rpc/rpc.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "wire/player/deflate.h"
#include "wire/player/frame.h"
#include "wire/player/messages.h"
#include "wire/player/text.h"
#include "wire/player/xdr.h"

namespace ccmorse::wire::player {
namespace {

// Hands a message's fields to libtirpc.
class Tirpc {
 public:
  Tirpc() : bytes_(1U << 16) {
    xdrmem_create(&stream_, reinterpret_cast<char*>(bytes_.data()),
                  static_cast<unsigned>(bytes_.size()), XDR_ENCODE);
  }
  ~Tirpc() { XDR_DESTROY(&stream_); }
  Tirpc(const Tirpc&) = delete;
  Tirpc& operator=(const Tirpc&) = delete;

  Bytes Taken() {
    return {bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(XDR_GETPOS(&stream_))};
  }

  void Value(const double& value) {
    double copy = value;
    Check(xdr_double(&stream_, &copy));
  }
  void Value(const std::uint8_t& value) {
    std::uint8_t copy = value;
    Check(xdr_u_char(&stream_, &copy));
  }
  void Value(const std::int8_t& value) { Value(std::int32_t{value}); }
  void Value(const std::uint16_t& value) {
    std::uint16_t copy = value;
    Check(xdr_u_short(&stream_, &copy));
  }
  void Value(const std::int16_t& value) {
    std::int16_t copy = value;
    Check(xdr_short(&stream_, &copy));
  }
  void Value(const std::uint32_t& value) {
    std::uint32_t copy = value;
    Check(xdr_u_int(&stream_, &copy));
  }
  void Value(const std::int32_t& value) {
    std::int32_t copy = value;
    Check(xdr_int(&stream_, &copy));
  }
  void Value(const std::int64_t& value) {
    std::int64_t copy = value;
    Check(xdr_int64_t(&stream_, &copy));
  }
  void Value(const std::uint64_t& value) {
    std::uint64_t copy = value;
    Check(xdr_uint64_t(&stream_, &copy));
  }
  template <std::size_t n>
  void Value(const std::array<std::uint8_t, n>& values) {
    auto copy = values;
    Check(xdr_opaque(&stream_, reinterpret_cast<char*>(copy.data()), n));
  }
  template <typename T, std::size_t n>
  void Value(const std::array<T, n>& values) {
    for (const T& value : values) Value(value);
  }
  template <typename T>
  void Value(const T& value) {
    T::Fields(value, *this);
  }
  void Single(const double& value) {
    auto copy = static_cast<float>(value);
    Check(xdr_float(&stream_, &copy));
  }
  template <typename T>
  void Count(const std::vector<T>& items) {
    Value(static_cast<std::uint32_t>(items.size()));
  }
  // With the NUL; an empty text is nothing at all.
  void Count(const std::string& text) {
    Value(static_cast<std::uint32_t>(text.empty() ? 0 : text.size() + 1));
  }
  void SingleItems(const std::vector<double>& items, std::size_t /*most*/ = 0) {
    std::vector<float> copy(items.begin(), items.end());
    auto* data = reinterpret_cast<char*>(copy.data());
    auto count = static_cast<unsigned>(copy.size());
    Check(xdr_array(&stream_, &data, &count, count, sizeof(float),
                    reinterpret_cast<xdrproc_t>(xdr_float)));
  }
  void Items(const std::vector<std::uint8_t>& items, std::size_t /*most*/ = 0) {
    Opaque({items.begin(), items.end()});
  }
  void Items(const std::string& text, std::size_t /*most*/ = 0) {
    Opaque({text.c_str(), text.c_str() + (text.empty() ? 0 : text.size() + 1)});
  }
  void Items(const std::vector<double>& items, std::size_t /*most*/ = 0) {
    std::vector<double> copy = items;
    auto* data = reinterpret_cast<char*>(copy.data());
    auto count = static_cast<unsigned>(copy.size());
    Check(xdr_array(&stream_, &data, &count, count, sizeof(double),
                    reinterpret_cast<xdrproc_t>(xdr_double)));
  }
  template <typename T>
  void Items(const std::vector<T>& items, std::size_t /*most*/ = 0) {
    Value(static_cast<std::uint32_t>(items.size()));
    for (const T& item : items) Value(item);
  }

 private:
  void Opaque(std::vector<char> bytes) {
    char* data = bytes.data();
    auto count = static_cast<unsigned>(bytes.size());
    Check(xdr_bytes(&stream_, &data, &count, count));
  }
  static void Check(int packed) { ASSERT_EQ(packed, 1); }

  Bytes bytes_;
  XDR stream_{};
};

// Fills a message with anything that its fields can hold.
class Filler {
 public:
  explicit Filler(unsigned seed) : random_(seed) {}

  void Value(double& value) { value = std::uniform_real_distribution<>(-1e6, 1e6)(random_); }
  template <typename T, std::size_t n>
  void Value(std::array<T, n>& values) {
    for (T& value : values) Value(value);
  }
  template <typename T>
  void Value(T& value) {
    if constexpr (std::is_integral_v<T>) {
      value = static_cast<T>(random_());
    } else {
      T::Fields(value, *this);
    }
  }
  void Single(double& value) {
    value = double{std::uniform_real_distribution<float>(-1e6F, 1e6F)(random_)};
  }
  template <typename Array>
  void Count(Array& /*items*/) {}
  void SingleItems(std::vector<double>& items, std::size_t most = 0) {
    items.resize(Length(most));
    for (double& item : items) Single(item);
  }
  template <typename T>
  void Items(std::vector<T>& items, std::size_t most = 0) {
    items.resize(Length(most));
    for (T& item : items) Value(item);
  }
  void Items(std::string& text, std::size_t most = 0) {
    text.resize(most == 1 ? 0 : Length(most == 0 ? 0 : most - 1));
    for (char& letter : text) letter = static_cast<char>('a' + random_() % 26);
  }

 private:
  std::size_t Length(std::size_t most) {
    constexpr std::size_t kMost = 7;
    return random_() % (1 + (most == 0 ? kMost : std::min(most, kMost)));
  }
  std::mt19937 random_;
};

unsigned Seed() {
  const char* const given = std::getenv("CCMORSE_TEST_SEED");
  return given != nullptr ? static_cast<unsigned>(std::atoi(given)) : std::random_device{}();
}

constexpr int kTimes = 20;  // each message, with other values

template <typename Struct>
void CheckMessage(const char* name, unsigned seed) {
  SCOPED_TRACE(std::string(name) + ", CCMORSE_TEST_SEED=" + std::to_string(seed));
  Filler filler(seed);
  for (int i = 0; i < kTimes; ++i) {
    Struct message;
    filler.Value(message);
    Tirpc reference;
    reference.Value(message);
    const Bytes ours = Encode(message);
    ASSERT_EQ(ours, reference.Taken());
    Struct back;
    ASSERT_TRUE(Decode(std::span(ours), back));
    ASSERT_TRUE(back == message);
    // Cut short or with something behind it, it is none.
    Bytes wrong = ours;
    if (!wrong.empty()) {
      wrong.resize(wrong.size() - 4);
      ASSERT_FALSE(Decode(std::span(wrong), back));
    }
    wrong = ours;
    wrong.resize(wrong.size() + 4);
    ASSERT_FALSE(Decode(std::span(wrong), back));
  }
}

TEST(PlayerXdr, EveryMessageHasTheBytesThatLibtirpcGivesIt) {
  const unsigned seed = Seed();
  std::cout << "CCMORSE_TEST_SEED=" << seed << "\n";
  int messages = 0;
#define PLAYER_MESSAGE(interface, code, type, subtype, name, body) \
  CheckMessage<body>(#interface " " #name, seed);                  \
  ++messages;
  CCMORSE_PLAYER_MESSAGES
#undef PLAYER_MESSAGE
  EXPECT_GT(messages, 150);
}

template <typename Struct>
void CheckText(std::uint16_t code, int type, int subtype, unsigned seed) {
  Filler filler(seed);
  for (int i = 0; i < kTimes; ++i) {
    Struct message;
    filler.Value(message);
    const Bytes bytes = Encode(message);
    const auto message_type = static_cast<MessageType>(type);
    const auto message_subtype = static_cast<std::uint8_t>(subtype);
    const auto text = ToText(code, message_type, message_subtype, bytes);
    ASSERT_TRUE(text);
    const auto back = FromText(code, message_type, message_subtype, *text);
    ASSERT_TRUE(back) << *text;
    ASSERT_EQ(*back, bytes) << *text;
    ASSERT_FALSE(FromText(code, message_type, message_subtype, *text + " 1"));
    const std::size_t last = text->rfind(' ');
    if (last == std::string::npos) continue;
    ASSERT_FALSE(FromText(code, message_type, message_subtype, text->substr(0, last))) << *text;
  }
}

TEST(PlayerText, EveryMessageComesBackFromItsText) {
  const unsigned seed = Seed();
#define PLAYER_MESSAGE(interface, code, type, subtype, name, body) \
  {                                                                \
    SCOPED_TRACE(#interface " " #name);                            \
    CheckText<body>(code, type, subtype, seed);                    \
  }
  CCMORSE_PLAYER_MESSAGES
#undef PLAYER_MESSAGE
}

TEST(PlayerText, IsInTheOrderOfTheWire) {
  Position2dData data;
  data.pos = {0.1, -2.0, 3.5};
  data.vel = {1e-9, 0.0, 0.25};
  data.stall = 1;
  EXPECT_EQ(ToText(kPosition2d, MessageType::kData, kPosition2dDataState, Encode(data)),
            "0.1 -2 3.5 1e-09 0 0.25 1");
  EXPECT_EQ(ToText(kSonar, MessageType::kData, kSonarDataRanges, Encode(SonarData{{0.1, 2.5}})),
            "2 0.1 2.5");
  EXPECT_EQ(ToText(kSpeech, MessageType::kCommand, kSpeechCmdSay, Encode(SpeechCmd{"Hi"})), "4869");
  EXPECT_EQ(FromText(kSonar, MessageType::kData, kSonarDataRanges, "4000000000 0.1"), std::nullopt);
  EXPECT_EQ(FromText(kSonar, MessageType::kData, 99, "1 0.1"), std::nullopt);
}

TEST(PlayerXdr, TheHeaderIsFortyBytesAsLibtirpcPacksThem) {
  const Header header{{0x0100007f, 6665, kLaser, 3}, MessageType::kAck, 200, 12.75, 9, 0};
  std::string out;
  Append(header, Bytes{1, 2, 3, 4}, out);
  Tirpc reference;
  reference.Value(header.address);
  reference.Value(static_cast<std::uint8_t>(header.type));
  reference.Value(header.subtype);
  reference.Value(header.time);
  reference.Value(header.sequence);
  reference.Value(std::uint32_t{4});
  const Bytes expected = reference.Taken();
  ASSERT_EQ(expected.size(), kHeaderSize);
  EXPECT_EQ(Bytes(out.begin(), out.end() - 4), expected);
}

// B.3's figures, measured on the real server.
TEST(PlayerXdr, SizesAreThoseOfTheRealServer) {
  LaserData laser;
  laser.ranges = {1.0, 2.0, 3.0};
  laser.intensity = {9, 8, 255};
  EXPECT_EQ(Encode(laser).size(), 52U);
  DeviceReq request;
  request.driver_name = "stage";
  EXPECT_EQ(Encode(request).size(), 36U);
  DeviceDevlist list;
  list.devices.resize(2);
  EXPECT_EQ(Encode(list).size(), 40U);
  SimulationPose2dReq pose;
  pose.name = "r0";
  EXPECT_EQ(Encode(pose).size(), 36U);
  BumperData bumpers;
  bumpers.bumpers.resize(5);
  EXPECT_EQ(Encode(bumpers).size(), 16U);
  RangerDataRange ranges;
  ranges.ranges.resize(2);
  EXPECT_EQ(Encode(ranges).size(), 24U);
  EXPECT_EQ(Encode(Position2dData{}).size(), 52U);
  Graphics2dCmdPoints points;
  points.points.resize(1);
  EXPECT_EQ(Encode(points).size(), 40U);
  MapData map;
  map.data.resize(2);
  EXPECT_EQ(Encode(map).size(), 32U);
}

// An empty name, as clients send it, is 28 bytes: no letters at all, not even the NUL.
TEST(PlayerXdr, ANameOfNoLettersIsRead) {
  Tirpc reference;
  reference.Value(Devaddr{0, 0, kLaser, 0});
  reference.Value(std::uint8_t{1});
  reference.Value(std::uint32_t{0});
  reference.Value(std::uint32_t{0});
  const Bytes bytes = reference.Taken();
  ASSERT_EQ(bytes.size(), 28U);
  DeviceReq request;
  ASSERT_TRUE(Decode(std::span(bytes), request));
  EXPECT_EQ(request.addr.interf, kLaser);
  EXPECT_EQ(request.driver_name, "");
}

TEST(PlayerXdr, CountsThatLieAreRefused) {
  RangerDataRange ranges;
  ranges.ranges = {1.0, 2.0};
  const Bytes good = Encode(ranges);
  RangerDataRange back;
  for (const std::size_t at : {3U, 7U}) {  // either count
    for (const int count : {0, 1, 3, 255}) {
      Bytes bad = good;
      bad[at] = static_cast<std::uint8_t>(count);
      EXPECT_FALSE(Decode(std::span(bad), back)) << at << " " << count;
    }
  }
  // Both agree on 4 billion elements: refused before any memory is asked for.
  Bytes huge(16, 0xff);
  EXPECT_FALSE(Decode(std::span(huge), back));
  EXPECT_LT(back.ranges.capacity(), 100U);
  // More than the struct has room for.
  LaserSetFilterConfig filter;
  filter.parameters.resize(9);
  LaserSetFilterConfig filter_back;
  const Bytes too_many = Encode(filter);
  EXPECT_FALSE(Decode(std::span(too_many), filter_back));
}

TEST(PlayerXdr, MapsAreDeflatedAndInflated) {
  Bytes plain(1000, 7);
  plain[500] = 1;
  const Bytes packed = Deflate(plain);
  EXPECT_LT(packed.size(), 100U);
  EXPECT_EQ(Inflate(packed, 1000), plain);
  EXPECT_FALSE(Inflate(packed, 999));
  EXPECT_FALSE(Inflate(Bytes{1, 2, 3}, 1000));
  EXPECT_FALSE(Inflate({}, 1000));
}

}  // namespace
}  // namespace ccmorse::wire::player
