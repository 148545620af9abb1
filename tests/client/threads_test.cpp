// Threads (thesis 3.3): one reads while others use the data; run under the thread sanitizer, too.

#include <atomic>
#include <thread>

#include "tests/client/client_fixture.h"

namespace ccmorse::test {
namespace {

using namespace CCMorse;

TEST(K17, AReadingThreadAndAUsingThread) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  LaserProxy laser(&client, 0);
  Position2dProxy position(&client, 0);
  WindowProxy& window = WindowProxy::GetInstance(&client, 20, 20);
  std::atomic<bool> done{false};
  std::thread reader([&] {
    while (!done) client.Read();
  });
  int scans = 0;
  while (scans < 100) {
    if (laser.IsFresh() && laser.IsValid()) {
      laser.NotFresh();
      ++scans;
      double sum = 0.0;
      for (unsigned i = 0; i < laser.GetCount(); ++i) sum += laser[i];
      EXPECT_NEAR(sum, 681 * 5.0 + 0.5, 1e-6);
      position.SetSpeed(0.1, position.GetYaw());
      window.SetPixel(window.GetX(position.GetXPos()), 0, 255, 0, 0);
      if (scans % 10 == 0) {
        EXPECT_EQ(window.GetPixel(0, 0), (Color_t{1, 2, 3}));
      }
      if (scans % 25 == 0) {
        position.SetMotorEnable(false);
        position.SetMotorEnable(true);
      }
    } else {
      std::this_thread::yield();
    }
  }
  done = true;
  reader.join();
  delete &window;
}

TEST(K17, TheSimpleLoop) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  LaserProxy laser(&client, 0);
  for (int i = 0; i < 20; ++i) {
    client.Read();
    EXPECT_TRUE(laser.IsFresh());
    laser.NotFresh();
  }
}

TEST(K17, GettersDoNotWaitForARead) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  Position2dProxy position(&client, 0);
  client.Read();
  server.Hold();
  server.ClearLines();
  std::thread reader([&] { client.Read(); });
  ASSERT_TRUE(server.WaitForLine("ccmorse read"));
  EXPECT_DOUBLE_EQ(position.GetXPos(), 1.0);  // would hang if Read() held the data
  position.SetSpeed(0.1, 0.0);
  EXPECT_FALSE(client.Peek(0));
  // A stop passes the Read() that waits.
  position.SetMotorEnable(false);
  EXPECT_TRUE(server.WaitForLine("s1r.motion set_speed [0.0, 0.0]"));
  server.Release();
  reader.join();
}

TEST(K17, ARequestDuringAReadIsAnsweredAfterIt) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Hold();
  std::thread reader([&] { client->Read(); });
  ASSERT_TRUE(server.WaitForLine("ccmorse read"));
  std::thread asker([&] {
    // Its time limit does not run while a read rightly holds the answers back.
    EXPECT_EQ(client->Request("time", "mode", MorseArgs(), 0.2).GetString(""),
              "Fixed Simulation Step");
  });
  ASSERT_TRUE(server.WaitForLine("time mode"));
  std::atomic<int> pings{0};
  server.OnLine([&](const std::string& line) {
    if (line == "ccmorse ping" && ++pings == 1) server.Release();
  });
  reader.join();
  asker.join();
}

TEST(K17, ManyThreadsAskAtOnce) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 50; ++i) {
        if (t == 0) {
          client->Read();
        } else {
          EXPECT_EQ(client->Request("s1r.pen", "get_pixel", MorseArgs(t, i)).GetSize(), 3U);
          client->Command("s1r.motion", "set_speed", MorseArgs(0.1 * t, 0.0));
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  client->Flush();
  client->Read();
  EXPECT_EQ(server.Count("s1r.pen get_pixel"), 150U);
  EXPECT_EQ(server.Count("s1r.motion set_speed"), 150U);
}

TEST(K17, ProxiesComeAndGoDuringReads) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  std::atomic<bool> done{false};
  std::thread reader([&] {
    while (!done) client.Read();
  });
  for (int i = 0; i < 200; ++i) {
    LaserProxy laser(&client, 0);
    laser.ConnectReadSignal([] {});
    Position2dProxy position(&client, 3);
    position.GetXPos();
  }
  done = true;
  reader.join();
}

TEST(K17, TheLibrarysOwnReadingThread) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  LaserProxy laser(&client, 0);
  client.StartThread();
  client.StartThread();  // runs already
  while (!laser.IsFresh()) std::this_thread::yield();
  client.StopThread();
  client.StopThread();
  laser.NotFresh();
  client.Read();  // ours again
  EXPECT_TRUE(laser.IsFresh());
  client.StartThread();
  laser.NotFresh();
  while (!laser.IsFresh()) std::this_thread::yield();
}  // the destructor stops the thread

TEST(K17, StopThreadDoesNotWaitForOtherClients) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  LaserProxy laser(&client, 0);
  server.Hold();
  client.StartThread();
  ASSERT_TRUE(server.WaitForLine("ccmorse read"));
  client.StopThread();
  server.Release();
  client.Read();  // takes up the Read() that was left
  EXPECT_TRUE(laser.IsFresh());
  EXPECT_EQ(server.Count("ccmorse read"), 1U);
}

TEST(K17, TheReadingThreadEndsWithTheConnection) {
  FakeServer server;
  PlayerClient client(kHost, server.port());
  client.StartThread();
  ASSERT_TRUE(server.WaitForLine("ccmorse read"));
  server.Disconnect(false);
  while (client.Connected()) std::this_thread::yield();
  client.StopThread();
  EXPECT_THROW(client.Read(), MorseError);
}

TEST(K17, ClosingWakesAThreadThatReads) {
  FakeServer server;
  const auto client = MorseClient::Share(kHost, server.port());
  server.Hold();
  std::thread reader([&] { EXPECT_THROW(client->Read(), MorseError); });
  ASSERT_TRUE(server.WaitForLine("ccmorse read"));
  client->Close();
  reader.join();
}

}  // namespace
}  // namespace ccmorse::test
