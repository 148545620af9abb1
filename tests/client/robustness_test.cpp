// What the client does when the simulator breaks, hangs, or sends nonsense.

#include <atomic>

#include "tests/client/client_fixture.h"

namespace ccmorse::test {
namespace {

using namespace CCMorse;

TEST(X20, AServerKilledDuringReadIsAnErrorWithinTwoSeconds) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.OnLine([&](const std::string& line) {
    if (line == "s1r.odometry get_local_data") server.Disconnect(false);
  });
  const auto start = std::chrono::steady_clock::now();
  const MorseError error = ErrorOf([&] { client->Read(); });
  EXPECT_LT(SecondsOf(start), 2.0);
  EXPECT_EQ(error.GetErrorFun(), "MorseClient::Read()");
  EXPECT_TRUE(Has(error.GetErrorStr(), std::to_string(server.port())));
  EXPECT_FALSE(client->Connected());
  EXPECT_THROW(client->Read(), MorseError);
  EXPECT_THROW(client->Peek(0), MorseError);
  EXPECT_THROW(client->Request("time", "now"), MorseError);
  client->Command("s1r.motion", "set_speed", MorseArgs(0.1, 0.0));  // ignored
  client->Flush();
}

TEST(X20, TheEndOfTheSimulationIsToldApart) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Answer("ccmorse read", "FAILED \"The simulation has ended at 120.000 s\"");
  const MorseError error = ErrorOf([&] { client->Read(); });
  EXPECT_TRUE(error.SimulationEnded());
  EXPECT_EQ(error.GetErrorStr(), "The simulation has ended at 120.000 s");
  EXPECT_TRUE(ErrorOf([&] { client->Read(); }).SimulationEnded());
}

TEST(K01, AHungServerIsPingedAndGivenUp) {
  for (const bool ccmorse : {true, false}) {
    FakeServer server(ccmorse ? FakeServer::Options() : Plain());
    const auto client = MorseClient::Share(kHost, server.port());
    server.FallSilent();
    const auto start = std::chrono::steady_clock::now();
    const MorseError error = ErrorOf([&] { client->Read(); });
    EXPECT_LT(SecondsOf(start), 4.0);
    EXPECT_TRUE(Has(error.GetErrorStr(), "does not answer"));
    EXPECT_EQ(server.Count(ccmorse ? "ccmorse ping" : "time now"), 1U);
  }
}

TEST(K01, AReadThatWaitsForOthersGoesOnWhilePingsAreAnswered) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Hold();
  std::atomic<int> pings{0};
  server.OnLine([&](const std::string& line) {
    // Long after a server without pongs would have been given up.
    if (line == "ccmorse ping" && ++pings == 3) server.Release();
  });
  client->Read();
  EXPECT_EQ(pings, 3);
  EXPECT_DOUBLE_EQ(client->GetTime(), 0.1);
}

TEST(K01, GarbageAndUnknownNumbersAreLeftAlone) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.SendRaw("\n\r\n   \nhello\n99999 SUCCESS 1\n-1 SUCCESS\n1 MAYBE\n\"\x01\xff\n{}\n");
  server.SendRaw("18446744073709551616 SUCCESS\n7\n");
  client->Read();
  client->Read();
  EXPECT_TRUE(client->Connected());
  EXPECT_DOUBLE_EQ(client->GetTime(), 0.2);
}

TEST(K01, LinesMayComeInPieces) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Answer("time mode", std::nullopt);
  server.OnLine([&](const std::string& line) {
    if (line != "time mode") return;
    const std::string id = server.Ids().back();
    for (const char c : id + " SUCCESS \"Best Effort\"\r\n") server.SendRaw(std::string(1, c));
  });
  EXPECT_EQ(client->Request("time", "mode").GetString(""), "Best Effort");
}

TEST(K01, AHalfLineAndThenTheEndIsAnError) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Answer("time mode", std::nullopt);
  server.OnLine([&](const std::string& line) {
    if (line != "time mode") return;
    server.SendRaw(server.Ids().back() + " SUCC");
    server.Disconnect();
  });
  EXPECT_THROW(client->Request("time", "mode"), MorseError);
}

TEST(K01, AnEndlessLineIsAnError) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Answer("time mode", std::nullopt);
  server.OnLine([&](const std::string& line) {
    if (line != "time mode") return;
    const std::string piece(1 << 20, 'x');
    for (int i = 0; i < 100; ++i) server.SendRaw(piece);
  });
  const MorseError error = ErrorOf([&] { client->Request("time", "mode", MorseArgs(), 60.0); });
  EXPECT_TRUE(Has(error.GetErrorStr(), "64 MiB"));
  EXPECT_FALSE(client->Connected());
}

TEST(K16, DataOfWrongTypesAreNotTaken) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  Position2dProxy position(&client, 0);
  LaserProxy laser(&client, 0);
  client.Read();
  ASSERT_TRUE(position.IsValid() && laser.IsValid());
  position.NotFresh();
  laser.NotFresh();
  server.SetData("s1r.pose", R"("x": "far", "y": null, "z": 0, "yaw": [], "pitch": 0, "roll": 0)");
  server.SetData("s1r.hokuyo", R"("range_list": [1.0, "x", {}])");
  client.Read();
  EXPECT_FALSE(position.IsValid() || position.IsFresh());
  EXPECT_FALSE(laser.IsValid() || laser.IsFresh());
  EXPECT_DOUBLE_EQ(position.GetXPos(), 1.0);
  EXPECT_EQ(laser.GetCount(), 682U);
  server.SetData("s1r.pose", R"("x": NaN, "y": 0, "z": 0, "yaw": 0, "pitch": 0, "roll": 0)");
  server.SetData("s1r.hokuyo", R"("range_list": 7)");
  client.Read();
  EXPECT_FALSE(position.IsValid() || laser.IsValid());
}

TEST(K16, AnswersThatAreNoJsonAreNotTaken) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  Position2dProxy position(&client, 0);
  for (const char* answer : {"SUCCESS {\"x\": ", "SUCCESS", "SUCCESS [1]", "FAILED", "PREEMPTED",
                             "SUCCESS {\"timestamp\": \"soon\"}"}) {
    server.Answer("s1r.pose get_local_data", answer);
    client.Read();
    EXPECT_FALSE(position.IsValid()) << answer;
    EXPECT_FALSE(position.IsFresh()) << answer;
  }
}

TEST(K16, AScannerWithoutSettingsIsNotValid) {
  FakeServer server;
  server.Answer("s1r.hokuyo get_configurations", "FAILED \"no\"");
  PlayerClient client(kHost, server.port());
  LaserProxy laser(&client, 0);
  Position2dProxy position(&client, 0);
  client.Read();
  EXPECT_FALSE(laser.IsValid());
  EXPECT_TRUE(position.IsValid());
}

TEST(K03, NamesThatDoNotResolveAreErrors) {
  const MorseError error = ErrorOf([] { MorseClient::Share("no such host", 4000); });
  EXPECT_TRUE(Has(error.GetErrorStr(), "no such host:4000"));
}

}  // namespace
}  // namespace ccmorse::test
