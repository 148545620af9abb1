#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/pose.h"
#include "grade/map_answer.h"
#include "grade/rubric.h"
#include "grade/worlds.h"
#include "scene/scenario.h"

namespace ccmorse::grade {

/// A robot's way as the judge saw it: one entry every kSampleTime.
struct Sample {
  double time = 0.0;      ///< s, simulated
  Pose2 pose;             ///< m, rad
  double speed = 0.0;     ///< m/s, forward
  double nearest = 0.0;   ///< m from the robot's middle to the nearest wall; infinite without any
  bool touching = false;  ///< it was blocked by what it touches
};
inline constexpr double kSampleTime = 0.1;  // s

struct RobotTrack {
  std::string name;
  std::vector<Sample> samples;
  double distance = 0.0;       ///< m
  std::uint64_t contacts = 0;  ///< times it ran against something
  double contact_time = 0.0;   ///< s
};

/// A value of a measure, or why there is none.
struct MeasureValue {
  std::optional<double> value;
  std::string why;
};

/// What a criterion came to.
struct CriterionResult {
  std::string name;
  std::string measure;
  double weight = 0.0;
  double points = 0.0;
  std::optional<double> value;
  std::string reason;  ///< where points were lost: why, and the teacher's hint
};

/// A run, judged.
struct Judgement {
  std::uint64_t seed = 0;
  double score = 0.0;   ///< 0..100
  std::string refused;  ///< why it counts nothing at all; "" where it counts
  std::vector<CriterionResult> criteria;
  double seconds = 0.0;            ///< simulated
  std::uint64_t hash = 0;          ///< of the state at the end
  scene::World world;              ///< as it was at the end
  std::vector<RobotTrack> robots;  ///< by name
  std::optional<Route> route;      ///< of tasks whose rubric measures a path
  std::vector<Vec2> path;          ///< handed in, m; empty where none was
  std::optional<MapPicture> map;  ///< of tasks whose rubric measures a map, where one was handed in
};

/// Judges the record of a run: a pure function of the record and the rubric, for the record is
/// simulated again, compared with its hashes, and measured from outside; what the program printed
/// or drew counts nothing. Measures are of the first robot by name, but for robots_gap_m, contacts,
/// contact_s, stuck_s and goal_error_m, which take the worst of the robots. What a map is worth is
/// limited to what the robot's lasers saw. docs/grading.md defines each. Throws
/// servers::RecordError for a record that is damaged, or none, or does not come out the same again.
Judgement Judge(const Rubric& rubric, const std::string& record);

}  // namespace ccmorse::grade
