#include "grade/rubric.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/nearest_name.h"
#include "scene/field.h"

namespace ccmorse::grade {
namespace {

using scene::Field;
using scene::ObjectReader;
using scene::Range;

constexpr double kFarthest = 1e6;

std::string TextOr(ObjectReader& reader, const std::string& key, const std::string& fallback) {
  return reader.Has(key) ? reader.Require(key).Text() : fallback;
}

std::string MeasureOf(const Field& field) {
  const std::string& name = field.Text();
  const auto& known = MeasureNames();
  if (!std::binary_search(known.begin(), known.end(), name)) {
    field.FailHere(
        fmt::format("is {}, which is no measure{}", scene::Quoted(name), DidYouMean(name, known)));
  }
  return name;
}

std::vector<Vec2> Points2(const Field& field, std::size_t least) {
  std::vector<Vec2> points;
  for (const Field& item : field.Items()) {
    const std::vector<Field> parts = item.Items();
    if (parts.size() != 2) item.FailHere("must be [x, y], m");
    const Range range{-1000.0, 1000.0};
    points.push_back({parts[0].Number(range), parts[1].Number(range)});
  }
  if (points.size() < least) field.FailHere(fmt::format("needs {} points or more", least));
  return points;
}

WorldDef ReadWorld(const Field& field, const std::string& folder) {
  ObjectReader reader(field);
  WorldDef world;
  const Field scenario = reader.Require("scenario");
  world.scenario = (std::filesystem::path(folder) / scenario.Text()).lexically_normal().string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(world.scenario, ignored)) {
    scenario.FailHere("names " + world.scenario + ", which is no file");
  }
  static const std::vector<std::string> kPresets{"none", "random"};
  static const std::vector<std::string> kStarts{"as given", "random"};
  world.random_presets = reader.Choice("presets", "none", kPresets) == "random";
  world.random_start = reader.Choice("start", "as given", kStarts) == "random";
  world.range_std = reader.Number("range_std", 0.0, {0.0, 1.0});
  world.maze = reader.Bool("maze", false);
  reader.Finish();
  return world;
}

Limits ReadLimits(const Field& field) {
  ObjectReader reader(field);
  Limits limits;
  limits.wall_s = reader.Number("wall_s", limits.wall_s, {0.1, 86400.0});
  limits.cpu_s = reader.Number("cpu_s", limits.cpu_s, {0.1, 86400.0});
  limits.memory_mb = reader.Number("memory_mb", limits.memory_mb, {16.0, 1e6});
  limits.processes = reader.Integer("processes", limits.processes, 1, 4096);
  limits.output_mb = reader.Number("output_mb", limits.output_mb, {0.001, 1024.0});
  reader.Finish();
  return limits;
}

Reference ReadReference(const Field& field) {
  ObjectReader reader(field);
  Reference reference;
  if (reader.Has("wall_distance_m")) {
    reference.wall_distance_m = reader.Require("wall_distance_m").Number({0.0, 100.0});
  }
  if (reader.Has("trajectory")) reference.trajectory = Points2(reader.Require("trajectory"), 2);
  if (reader.Has("goals")) {
    const Field goals = reader.Require("goals");
    if (goals.value().IsObject()) {
      ObjectReader robots(goals);
      for (const auto& member : goals.value().AsObject()) {
        reference.goals[member.first] = Points2(robots.Require(member.first), 1);
      }
      if (reference.goals.empty()) goals.FailHere("names no robot");
    } else {
      reference.goals[""] = Points2(goals, 1);
    }
  }
  reader.Finish();
  return reference;
}

Criterion::Condition ReadCondition(const Field& field) {
  ObjectReader reader(field);
  Criterion::Condition condition;
  condition.measure = MeasureOf(reader.Require("measure"));
  if (!reader.Has("at_least") && !reader.Has("at_most")) {
    field.FailHere("needs 'at_least' or 'at_most'");
  }
  constexpr Range kAny{-kFarthest, kFarthest};
  if (reader.Has("at_least")) condition.least = reader.Require("at_least").Number(kAny);
  if (reader.Has("at_most")) condition.most = reader.Require("at_most").Number(kAny);
  reader.Finish();
  return condition;
}

Criterion ReadCriterion(const Field& field) {
  ObjectReader reader(field);
  Criterion criterion;
  criterion.name = reader.Require("name").Text();
  criterion.measure = MeasureOf(reader.Require("measure"));
  criterion.weight = reader.Require("weight").Number({0.0, 100.0, true});
  const Field full = reader.Require("full");
  criterion.full = full.Number({-kFarthest, kFarthest});
  criterion.none = reader.Require("none").Number({-kFarthest, kFarthest});
  if (criterion.full == criterion.none) full.FailHere("is the same as 'none'");
  criterion.hint = TextOr(reader, "hint", "");
  if (reader.Has("only_if")) {
    const Field given = reader.Require("only_if");
    if (given.value().IsArray()) {
      for (const Field& item : given.Items()) criterion.only_if.push_back(ReadCondition(item));
    } else {
      criterion.only_if.push_back(ReadCondition(given));
    }
  }
  reader.Finish();
  return criterion;
}

// A measure that compares with something the rubric lacks would never give a point.
void RequireReference(const Criterion& criterion, const Reference& reference, const Field& field) {
  const auto lacks = [&](const char* measure, bool there, const char* key) {
    if (criterion.measure != measure || there) return;
    field.FailHere(fmt::format("measures {}, which needs reference.{}", measure, key));
  };
  lacks("wall_error_m", reference.wall_distance_m.has_value(), "wall_distance_m");
  lacks("overshoot", reference.wall_distance_m.has_value(), "wall_distance_m");
  lacks("tracking_error_m", !reference.trajectory.empty(), "trajectory");
  lacks("goal_error_m", !reference.goals.empty(), "goals");
}

}  // namespace

const std::vector<std::string>& MeasureNames() {
  static const std::vector<std::string> kNames = {
      "cell_accuracy", "contact_s",        "contacts",    "coverage",     "distance_m",
      "explored",      "final_error_m",    "finished",    "goal_error_m", "length_ratio",
      "map_iou",       "overshoot",        "path_valid",  "robots_gap_m", "stuck_s",
      "time_s",        "tracking_error_m", "turning_rad", "wall_error_m"};
  return kNames;
}

Rubric ParseRubric(const std::string& text, const std::string& file) {
  Json json;
  try {
    json = Json::Parse(text);
  } catch (const JsonError& error) {
    throw Error(fmt::format("{}:{}: {}", file, error.line(), error.what()));
  }
  Rubric rubric;
  rubric.file = file;
  rubric.folder = std::filesystem::path(file).parent_path().string();
  const Field root(json, "", file);
  ObjectReader reader(root);
  rubric.task = reader.Require("task").Identifier();
  rubric.title = TextOr(reader, "title", rubric.task);
  const Field program = reader.Require("program");
  rubric.program = program.Text();
  if (rubric.program.empty() || rubric.program.find('/') != std::string::npos) {
    program.FailHere("must be the name of a file in the submission's folder");
  }
  if (reader.Has("arguments")) {
    for (const Field& item : reader.Require("arguments").Items()) {
      rubric.arguments.push_back(item.Text());
    }
  }
  rubric.seconds = reader.Require("seconds").Number({0.1, 1e5});
  if (reader.Has("limits")) rubric.limits = ReadLimits(reader.Require("limits"));
  const Field worlds = reader.Require("worlds");
  for (const Field& item : worlds.Items()) {
    rubric.worlds.push_back(ReadWorld(item, rubric.folder));
  }
  if (rubric.worlds.empty()) worlds.FailHere("needs one world or more");
  if (reader.Has("reference")) rubric.reference = ReadReference(reader.Require("reference"));
  const Field criteria = reader.Require("criteria");
  double sum = 0.0;
  std::set<std::string> names;
  for (const Field& item : criteria.Items()) {
    rubric.criteria.push_back(ReadCriterion(item));
    const Criterion& criterion = rubric.criteria.back();
    RequireReference(criterion, rubric.reference, item);
    if (!names.insert(criterion.name).second) item.FailHere("has the name of another criterion");
    sum += criterion.weight;
  }
  if (std::fabs(sum - 100.0) > 1e-9) {
    criteria.FailHere(fmt::format("have weights of {} together, must be 100", sum));
  }
  rubric.pass = reader.Number("pass", rubric.pass, {0.0, 100.0});
  reader.Finish();
  return rubric;
}

Rubric LoadRubric(const std::string& file) { return ParseRubric(ReadFile(file), file); }

double Points(const Criterion& criterion, double value) {
  const double share = (value - criterion.none) / (criterion.full - criterion.none);
  return criterion.weight * std::clamp(share, 0.0, 1.0);
}

}  // namespace ccmorse::grade
