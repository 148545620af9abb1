// A Player client's session without a socket: queue, replace rules, rounds (specs: player.md B.5,
// B.6).

#include "servers/player/player_session.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "wire/player/messages.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

// A device that publishes what the test says.
class Echo : public Device {
 public:
  explicit Echo(std::uint16_t index = 0)
      : Device(wire::kOpaque, index, "echo", {{MessageType::kData, 1}}) {}
  void Say(double time, std::uint8_t value, std::uint8_t subtype = 1, std::size_t size = 1) {
    wire::OpaqueData data;
    data.data.assign(size, value);
    Publish(subtype, time, wire::Body::Of(data));
  }
};

struct Received {
  wire::Header header;
  wire::Bytes body;
};

class PlayerSessionTest : public ::testing::Test {
 protected:
  PlayerSessionTest() {
    devices_.Add(one_);
    devices_.Add(two_);
    session_ = std::make_unique<PlayerSession>(devices_, 6665, [] { return 4.5; });
  }

  void Ask(std::uint16_t interface_code, std::uint8_t subtype, const wire::Bytes& body = {}) {
    std::string bytes;
    wire::Append({{0, 0, interface_code, 0}, MessageType::kRequest, subtype, 0.0, 0, 0}, body,
                 bytes);
    session_->Take(bytes);
    while (session_->ServeNext()) {
    }
  }
  void Subscribe(std::uint16_t index, std::uint8_t access = 1) {
    wire::DeviceReq wanted;
    wanted.addr = {0, 0, wire::kOpaque, index};
    wanted.access = access;
    Ask(wire::kPlayer, wire::kPlayerReqDev, wire::Encode(wanted));
    Deliver();
  }
  void Pull() {
    Ask(wire::kPlayer, wire::kPlayerReqDatamode, wire::Encode(wire::DeviceDatamodeReq{2}));
    Deliver();
  }
  void AddRule(const wire::AddReplaceRuleReq& rule) {
    Ask(wire::kPlayer, wire::kPlayerReqAddReplaceRule, wire::Encode(rule));
    const auto replies = Deliver();
    ASSERT_EQ(replies.size(), 1U);
    ASSERT_EQ(replies[0].header.type, MessageType::kAck);
  }
  std::vector<Received> Deliver() {
    std::string out;
    session_->Deliver(out);
    wire::FrameReader reader;
    reader.Append(out);
    std::vector<Received> messages;
    while (const auto message = reader.Next()) {
      messages.push_back({message->header, {message->body.begin(), message->body.end()}});
    }
    return messages;
  }
  static std::uint8_t ValueOf(const Received& message) {
    wire::OpaqueData data;
    EXPECT_TRUE(wire::Decode(std::span(message.body), data));
    return data.data.at(0);
  }

  std::shared_ptr<Echo> one_ = std::make_shared<Echo>(0);
  std::shared_ptr<Echo> two_ = std::make_shared<Echo>(1);
  DeviceList devices_;
  std::unique_ptr<PlayerSession> session_;
};

TEST_F(PlayerSessionTest, PullHoldsDataBackUntilTheyAreAskedFor) {
  Pull();
  Subscribe(0);
  one_->Say(1.0, 7);
  EXPECT_TRUE(Deliver().empty());
  Ask(wire::kPlayer, wire::kPlayerReqData);
  const auto round = Deliver();
  ASSERT_EQ(round.size(), 3U);
  EXPECT_EQ(round[0].header.type, MessageType::kAck);
  EXPECT_EQ(ValueOf(round[1]), 7);
  EXPECT_EQ(round[2].header.type, MessageType::kSynch);
  one_->Say(2.0, 8);
  EXPECT_TRUE(Deliver().empty());  // a SYNCH ends the round
}

TEST_F(PlayerSessionTest, AnEmptyRoundIsAcknowledgedAndWaits) {
  Pull();
  Subscribe(0);
  Ask(wire::kPlayer, wire::kPlayerReqData);
  ASSERT_EQ(Deliver().size(), 1U);
  EXPECT_TRUE(session_->waits());
  EXPECT_TRUE(Deliver().empty());  // H3
  one_->Say(1.0, 7);
  const auto round = Deliver();
  ASSERT_EQ(round.size(), 2U);
  EXPECT_EQ(round[1].header.type, MessageType::kSynch);
  EXPECT_FALSE(session_->waits());
}

TEST_F(PlayerSessionTest, RepliesTakeWhatWasQueuedBeforeThemAlong) {
  Pull();
  Subscribe(0);
  one_->Say(1.0, 1);
  Ask(wire::kOpaque, 99);
  one_->Say(2.0, 2);
  const auto sent = Deliver();
  ASSERT_EQ(sent.size(), 2U);
  EXPECT_EQ(ValueOf(sent[0]), 1);
  EXPECT_EQ(sent[1].header.type, MessageType::kNack);
  EXPECT_EQ(session_->queued(), 1U);
}

TEST_F(PlayerSessionTest, TheQueueIsLimitedAndWhatIsLostIsCounted) {
  Pull();
  Subscribe(0);
  for (int i = 0; i < 1030; ++i) one_->Say(1.0 + i, static_cast<std::uint8_t>(i));
  EXPECT_EQ(session_->queued(), 1024U);
  Ask(wire::kPlayer, wire::kPlayerReqData);
  auto round = Deliver();
  ASSERT_EQ(round.size(), 1026U);
  EXPECT_EQ(ValueOf(round[1]), 0);  // the oldest are kept
  EXPECT_EQ(round.back().header.subtype, wire::kPlayerSynchOverflow);
  wire::Overflow overflow;
  ASSERT_TRUE(wire::Decode(std::span(round.back().body), overflow));
  EXPECT_EQ(overflow.dropped, 6U);
  Ask(wire::kPlayer, wire::kPlayerReqData);
  one_->Say(5000.0, 1);
  round = Deliver();
  EXPECT_EQ(round.back().header.subtype, wire::kPlayerSynchOk);  // counted once
}

TEST_F(PlayerSessionTest, RepliesAreNeverDropped) {
  Pull();
  Subscribe(0);
  for (int i = 0; i < 1030; ++i) one_->Say(1.0 + i, 1);
  Ask(wire::kOpaque, 99);
  EXPECT_EQ(Deliver().back().header.type, MessageType::kNack);
}

TEST_F(PlayerSessionTest, MemoryForAClientThatDoesNotReadIsBounded) {
  Pull();
  Subscribe(0);
  for (int i = 0; i < 100; ++i) one_->Say(1.0 + i, 1, 1, 1U << 20);
  EXPECT_LE(session_->queued_bytes(), SessionLimits{}.most_queued_bytes);
  EXPECT_GT(session_->dropped(), 0U);
}

TEST_F(PlayerSessionTest, AReplaceRuleKeepsTheNewestAtTheEndOfTheQueue) {
  Pull();
  Subscribe(0);
  Subscribe(1);
  AddRule({-1, -1, 1, -1, 1});
  one_->Say(1.0, 1);
  two_->Say(1.0, 2);
  one_->Say(2.0, 3, 2);  // another subtype
  one_->Say(2.0, 4);
  Ask(wire::kPlayer, wire::kPlayerReqData);
  const auto round = Deliver();
  ASSERT_EQ(round.size(), 5U);
  EXPECT_EQ(ValueOf(round[1]), 2);
  EXPECT_EQ(ValueOf(round[2]), 3);
  EXPECT_EQ(ValueOf(round[3]), 4);
}

TEST_F(PlayerSessionTest, TheFirstRuleThatMatchesWinsAndTheSamePatternIsOverwritten) {
  Pull();
  Subscribe(0);
  Subscribe(1);
  AddRule({wire::kOpaque, 0, -1, -1, 2});  // ignore
  AddRule({-1, -1, -1, -1, 0});            // accept
  one_->Say(1.0, 1);
  two_->Say(1.0, 2);
  EXPECT_EQ(session_->queued(), 1U);
  Ask(wire::kPlayer, wire::kPlayerReqData);
  Deliver();
  AddRule({wire::kOpaque, 0, -1, -1, 0});
  one_->Say(2.0, 3);
  EXPECT_EQ(session_->queued(), 1U);
  Ask(wire::kPlayer, wire::kPlayerReqAddReplaceRule,
      wire::Encode(wire::AddReplaceRuleReq{-1, -1, -1, -1, 3}));
  EXPECT_EQ(Deliver().back().header.type, MessageType::kNack);
}

TEST_F(PlayerSessionTest, PushSendsAtOnce) {
  Subscribe(0);
  one_->Say(1.0, 7);
  const auto sent = Deliver();
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(ValueOf(sent[0]), 7);
  EXPECT_EQ(sent[0].header.time, 1.0);
  EXPECT_EQ(sent[0].header.address, (wire::Devaddr{0x0100007f, 6665, wire::kOpaque, 0}));
}

TEST_F(PlayerSessionTest, TimesOfADeviceAreAboveZeroAndGrow) {
  Subscribe(0);
  one_->Say(0.0, 1);
  one_->Say(0.0, 2);
  one_->Say(1.0, 3);
  const auto sent = Deliver();
  ASSERT_EQ(sent.size(), 3U);
  EXPECT_GT(sent[0].header.time, 0.0);
  EXPECT_GT(sent[1].header.time, sent[0].header.time);
  EXPECT_EQ(sent[2].header.time, 1.0);
}

TEST_F(PlayerSessionTest, SubscriptionsAreCountedAndEndWithTheSession) {
  Subscribe(0);
  Subscribe(0);
  Subscribe(0, 2);
  EXPECT_TRUE(one_->subscribed());
  one_->Say(1.0, 1);
  EXPECT_EQ(Deliver().size(), 1U);
  Subscribe(0, 2);
  EXPECT_FALSE(one_->subscribed());
  Subscribe(0, 2);  // nothing is left to close
  Subscribe(1);
  session_ = nullptr;
  EXPECT_FALSE(two_->subscribed());
}

TEST_F(PlayerSessionTest, CountsThatLieAreRefused) {
  // A name that claims to be longer than the body.
  wire::Bytes body = wire::Encode(wire::DeviceReq{{0, 0, wire::kOpaque, 0}, 1, "x"});
  body[20] = 0x7f;
  Ask(wire::kPlayer, wire::kPlayerReqDev, body);
  EXPECT_EQ(Deliver().at(0).header.type, MessageType::kNack);
  EXPECT_FALSE(one_->subscribed());
}

}  // namespace
}  // namespace ccmorse::servers::player
