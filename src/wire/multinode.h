#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace ccmorse::wire {

/// Bytes of one message between nodes; who sends more is let go.
inline constexpr std::size_t kLongestNodeLine = std::size_t{16} << 20;

/// One robot of a scene that several simulators share (specs: morse.md A.7).
struct NodeRobot {
  std::array<double, 3> position{};  ///< m
  std::array<double, 3> rotation{};  ///< roll, pitch, yaw, rad
  // Beyond MORSE, under "__ccmorse": with these the robots of other nodes move as they do there.
  std::optional<std::array<double, 3>> command;  ///< v m/s, w rad/s, sideways m/s: of this tick
  std::optional<std::uint64_t> hash;             ///< of all that the robot has been; at the end
  bool operator==(const NodeRobot&) const = default;
};

/// What a node tells in a tick, and what it is told of the others. All numbers are finite.
struct NodeScene {
  std::map<std::string, NodeRobot> robots;
  std::array<double, 3> time{};  ///< s: simulated, of one tick, wall-clock
  /// How many nodes there are to be: whoever says so is in lock-step with the others. 0: plain
  /// MORSE, which takes what there is.
  int nodes = 0;
  bool operator==(const NodeScene&) const = default;
};

struct NodeMessage {
  std::string node;
  NodeScene scene;
};

/// `[name, {robot: [[x, y, z], [roll, pitch, yaw]], ..., "__time": [t, dt, real]}]` and a line end.
std::string NodeMessageLine(const NodeMessage& message);
/// Of such a line, with or without its end. Throws Error that says what is wrong with it.
NodeMessage ParseNodeMessage(std::string_view line);

/// What the server answers: the object alone, and a line end.
std::string NodeAnswerLine(const NodeScene& scene);
/// Throws Error that says what is wrong with it.
NodeScene ParseNodeAnswer(std::string_view line);

}  // namespace ccmorse::wire
