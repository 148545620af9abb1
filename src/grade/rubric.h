#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/pose.h"

namespace ccmorse::grade {

/// A world in which submissions run; what is drawn at random depends on the seed alone.
struct WorldDef {
  std::string scenario;         ///< file, from the rubric's folder
  bool random_presets = false;  ///< the dynamic obstacles that are up are drawn
  bool random_start = false;    ///< the robots' start poses are drawn
  double range_std = 0.0;       ///< m, >= 0, noise of the laser scanners; 0: the scenario's own
  bool maze = false;            ///< walls of a maze in place of all boxes but the border
};

/// What one run may use.
struct Limits {
  double wall_s = 60.0;    ///< s of wall-clock time
  double cpu_s = 60.0;     ///< s, all its processes together
  double memory_mb = 512;  ///< MB, all its processes together
  int processes = 64;      ///< and threads, at a time
  double output_mb = 4;    ///< MB of what it prints
};

/// What a measure is compared with; which of them counts is up to the measure.
struct Reference {
  std::optional<double> wall_distance_m;  ///< m from the robot's middle to the nearest wall
  std::vector<Vec2> trajectory;           ///< m, corners of a line
  /// m, in the order in which they are to be visited, by robot; "" is the first robot by name.
  std::map<std::string, std::vector<Vec2>> goals;
};

/// A measure and what it is worth.
struct Criterion {
  std::string name;     ///< for people, no two alike
  std::string measure;  ///< one of MeasureNames()
  double weight = 0.0;  ///< points, > 0; all together are 100
  double full = 0.0;    ///< this value gives all points,
  double none = 0.0;    ///< this gives none; between them they rise evenly
  std::string hint;     ///< what to look at where points were lost
  /// Counts only where another measure lies within these bounds: who does nothing touches nothing.
  struct Condition {
    std::string measure;
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
  };
  std::vector<Condition> only_if;  ///< all of them have to hold
};

/// How a task is graded: the file rubric.json in the task's folder (docs/grading.md).
struct Rubric {
  std::string task;
  std::string title;
  std::string program;                 ///< what `make` builds
  std::vector<std::string> arguments;  ///< {host} {port} {seed} {scenario} {map} ... are put in
  double seconds = 0.0;                ///< simulated, of one run, > 0
  Limits limits;
  std::vector<WorldDef> worlds;  ///< one or more; seed k takes worlds[k % size]
  Reference reference;
  std::vector<Criterion> criteria;  ///< one or more
  double pass = 60.0;               ///< score from which on it is passed, 0..100
  std::string file;                 ///< that it was read from
  std::string folder;               ///< of the file
};

/// The measures there are, sorted (judge.h).
const std::vector<std::string>& MeasureNames();

/// Reads and checks a rubric; `file` names it in messages, and worlds are looked for in its folder.
/// Throws Error "FILE:LINE: ..." with the nearest known key.
Rubric ParseRubric(const std::string& text, const std::string& file);
Rubric LoadRubric(const std::string& file);

/// Points of a criterion for a value: weight * clamp((value - none) / (full - none), 0, 1).
double Points(const Criterion& criterion, double value);

}  // namespace ccmorse::grade
