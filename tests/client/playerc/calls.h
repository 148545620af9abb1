#pragma once

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

#include "libplayerc++/playerc++.h"
#include "tests/support/player_double.h"

namespace ccmorse::test {

// As programs for Player write it.
using namespace PlayerCc;
using connection_t = ClientProxy::connection_t;

/// Calls every method once (see generate.py) against a server that has a device of each interface
/// and agrees to everything.
class PlayerMethods : public ::testing::Test {
 protected:
  PlayerMethods() { server.AgreeToAll(); }

  static std::vector<PlayerDouble::Device> Everything() {
    std::vector<PlayerDouble::Device> devices;
    for (std::uint16_t code = 2; code <= 66; ++code) {
      if (!wire::player::InterfaceName(code).empty()) devices.push_back({code, 0, "double"});
    }
    return devices;
  }

  // A method may throw PlayerError, as for an index that is not there, and nothing else.
  template <typename Method>
  void Call(const Method& method) {
    try {
      method();
    } catch (const PlayerError& error) {
      EXPECT_FALSE(error.GetErrorStr().empty());
      EXPECT_FALSE(error.GetErrorFun().empty());
    }
    ++called;
  }

  void Feed() { server.Data(PLAYER_LASER_CODE, 0, 1, ++time, wire::player::LaserData()); }

  void RunAndStop(PlayerClient& running) {
    std::atomic<bool> done{false};
    std::thread stopper([&] {
      while (!done) {
        Feed();
        running.Stop();
        std::this_thread::yield();
      }
    });
    running.Run(0);
    done = true;
    stopper.join();
  }

  PlayerDouble server{Everything()};
  PlayerClient client{"localhost", server.port()};
  int called = 0;
  double time = 0.0;
  // Arguments.
  std::string text = "name";
  std::string prefix = ::testing::TempDir() + "ccmorse_frame";
  std::vector<std::uint8_t> buffer = std::vector<std::uint8_t>(4096);
  std::vector<std::int8_t> cells = std::vector<std::int8_t>(4096);
  std::vector<player_point_2d_t> points2 = std::vector<player_point_2d_t>(4);
  std::vector<player_point_3d_t> points3 = std::vector<player_point_3d_t>(4);
  std::vector<double> numbers = std::vector<double>(6);
  bool flag = false;
  std::int32_t integer = 0;
  double number = 0.0;
  char* given = nullptr;
  player_opaque_data_t opaque{};
  player_audio_seq_t tones{};
  player_audio_mixer_channel_list_t levels{};
  player_blackboard_entry_t entry{};
};

}  // namespace ccmorse::test
