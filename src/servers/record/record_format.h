#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ccmorse::servers {

// What a record's topics are called; docs/records.md says what is in them.
inline constexpr std::string_view kStartTopic = "/start";
inline constexpr std::string_view kInputTopic = "/input";
inline constexpr std::string_view kHashTopic = "/hash";
inline constexpr std::string_view kEndTopic = "/end";
inline constexpr std::string_view kSceneTopic = "/scene";
inline constexpr std::string_view kTransformTopic = "/tf";

// Names of the messages' schemas. Foxglove knows its own by their names.
inline constexpr std::string_view kStartSchema = "ccmorse.Start";
inline constexpr std::string_view kInputSchema = "ccmorse.Input";
inline constexpr std::string_view kHashSchema = "ccmorse.Hash";
inline constexpr std::string_view kEndSchema = "ccmorse.End";
inline constexpr std::string_view kDataSchema = "ccmorse.Data";
inline constexpr std::string_view kLaserScanSchema = "foxglove.LaserScan";
inline constexpr std::string_view kPoseSchema = "foxglove.PoseInFrame";
inline constexpr std::string_view kTransformsSchema = "foxglove.FrameTransforms";
inline constexpr std::string_view kSceneSchema = "foxglove.SceneUpdate";

/// The number in a record's start that changes when a program for older records would misread it.
inline constexpr std::int64_t kRecordFormat = 1;

/// The JSON schema of a name above: the fields that we write.
std::string SchemaText(std::string_view name);

/// Simulated time of a tick in ns, a message's log time, and back. `frequency` in Hz.
std::uint64_t LogTime(std::uint64_t tick, double frequency);
std::uint64_t TickOf(std::uint64_t log_time, double frequency);

/// 64 bits as 16 hexadecimal digits: JSON's numbers would lose some of them.
std::string HashText(std::uint64_t hash);
/// Reads HashText()'s form; false when it is none.
bool ParseHash(std::string_view text, std::uint64_t* hash);

}  // namespace ccmorse::servers
