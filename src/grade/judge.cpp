#include "grade/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "grade/map_answer.h"
#include "servers/record/replay.h"
#include "sim/actuators/answers.h"

namespace ccmorse::grade {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kStuckTime = 5.0;       // s
constexpr double kStuckWay = 0.05;       // m
constexpr double kLeastDriven = 0.5;     // m, of who is to be praised for touching nothing
constexpr double kEndTolerance = 0.045;  // m, of a path's ends: a cell and its neighbours
constexpr double kTimeSlack = 0.5;       // s before the limit that still count as its end

// An answer and when it came.
struct TimedAnswer {
  std::string text;
  Pose2 pose;  // of the robot then
};

// All that is looked at while the record is simulated again.
struct Evidence {
  std::vector<RobotTrack> robots;
  std::map<std::string, TimedAnswer> answers;  // the first robot's
  double gap = kEndless;                       // m, smallest between two robots
};

std::vector<Vec2> FootprintAt(const sim::Robot& robot) {
  std::vector<Vec2> placed(robot.model().footprint.size());
  Place(robot.model().footprint, robot.pose(), placed);
  return placed;
}

class Watch {
 public:
  explicit Watch(const servers::Replay& replay)
      : replay_(replay),
        every_(std::max<std::uint64_t>(
            1, static_cast<std::uint64_t>(
                   std::lround(kSampleTime * replay.info().scenario.time.frequency)))) {
    for (const auto& robot : Sim().robots()) seen_.robots.push_back({robot->name(), {}, 0, 0, 0});
  }

  void Look() {
    const bool sample = Sim().tick() % every_ == 0;
    std::vector<std::vector<Vec2>> prints;
    for (std::size_t i = 0; i < Sim().robots().size(); ++i) {
      const sim::Robot& robot = *Sim().robots()[i];
      if (Sim().robots().size() > 1) prints.push_back(FootprintAt(robot));
      if (!sample) continue;
      const Vec2 at{robot.pose().x, robot.pose().y};
      seen_.robots[i].samples.push_back({Sim().time(), robot.pose(), robot.twist().v,
                                         WallDistance(Sim().world().scene(), at), robot.stalled()});
    }
    for (std::size_t i = 0; i < prints.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        seen_.gap = std::min(seen_.gap, PolygonDistance(prints[i], prints[k]));
      }
    }
    TakeAnswers();
  }

  Evidence End() {
    TakeAnswers();
    for (std::size_t i = 0; i < Sim().robots().size(); ++i) {
      const sim::RobotTally& tally = Sim().robots()[i]->tally();
      seen_.robots[i].distance = tally.distance;
      seen_.robots[i].contacts = tally.contacts;
      seen_.robots[i].contact_time = tally.stalled;
    }
    return std::move(seen_);
  }

 private:
  const sim::Simulation& Sim() const { return replay_.simulation(); }

  void TakeAnswers() {
    if (Sim().robots().empty()) return;
    const sim::Robot& robot = *Sim().robots().front();
    const auto* const answers =
        dynamic_cast<const sim::Answers*>(Sim().FindComponent(robot.name() + ".answers"));
    if (answers == nullptr || answers->revision() == revision_) return;
    for (const auto& [name, answer] : answers->answers()) {
      if (answer.revision > revision_) seen_.answers[name] = {answer.text, before_};
    }
    revision_ = answers->revision();
  }

 public:
  // An answer of a tick is about what the sensors saw at its start.
  void Before() {
    if (!Sim().robots().empty()) before_ = Sim().robots().front()->pose();
  }

 private:
  const servers::Replay& replay_;
  std::uint64_t every_;
  Evidence seen_;
  std::uint64_t revision_ = 0;
  Pose2 before_;
};

double LengthOf(const std::vector<Vec2>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  }
  return length;
}

// s within windows of kStuckTime in which the robot stayed closer than kStuckWay to where they
// began.
double StuckTime(const std::vector<Sample>& samples) {
  double stuck = 0.0;
  double counted_to = -kEndless;
  for (std::size_t i = 0, k = 0; i < samples.size(); ++i) {
    while (k + 1 < i && samples[i].time - samples[k + 1].time >= kStuckTime - 1e-9) ++k;
    const double begin = samples[k].time;
    if (samples[i].time - begin < kStuckTime - 1e-9) continue;
    bool near = true;
    for (std::size_t m = k + 1; m <= i && near; ++m) {
      near = std::hypot(samples[m].pose.x - samples[k].pose.x,
                        samples[m].pose.y - samples[k].pose.y) < kStuckWay;
    }
    if (!near) continue;
    stuck += samples[i].time - std::max(begin, counted_to);
    counted_to = samples[i].time;
  }
  return stuck;
}

class Measures {
 public:
  Measures(const Rubric& rubric, const servers::RecordInfo& info, const Evidence& seen,
           Judgement& judgement)
      : rubric_(rubric), info_(info), seen_(seen), judgement_(judgement) {}

  const MeasureValue& Of(const std::string& name) {
    const auto found = known_.find(name);
    if (found != known_.end()) return found->second;
    return known_.emplace(name, Compute(name)).first->second;
  }

 private:
  const RobotTrack& Robot() const { return seen_.robots.front(); }
  const std::vector<Sample>& Samples() const { return Robot().samples; }
  double Seconds() const { return judgement_.seconds; }
  bool Finished() const { return info_.complete && Seconds() < rubric_.seconds - kTimeSlack; }

  double Worst(const std::function<double(const RobotTrack&)>& value) const {
    double worst = 0.0;
    for (const RobotTrack& robot : seen_.robots) worst = std::max(worst, value(robot));
    return worst;
  }

  MeasureValue Compute(const std::string& name) {
    try {
      return {Value(name), ""};
    } catch (const Error& error) {
      return {std::nullopt, error.what()};
    }
  }

  double Value(const std::string& name) {
    if (name == "time_s") return Seconds();
    if (name == "finished") return Finished() ? 1.0 : 0.0;
    if (name == "distance_m") return Robot().distance;
    if (name == "coverage") return Coverage();
    if (name == "contacts" || name == "contact_s" || name == "stuck_s") return Clumsiness(name);
    if (name == "robots_gap_m") return Gap();
    if (name == "path_valid") return PathValid();
    if (name == "length_ratio") return LengthRatio();
    if (name == "turning_rad") return Turning();
    if (name == "map_iou") return Map().iou;
    if (name == "cell_accuracy") return Map().accuracy;
    if (name == "explored") return Map().explored;
    if (name == "wall_error_m") return WallError();
    if (name == "overshoot") return Overshoot();
    if (name == "tracking_error_m") return TrackingError();
    if (name == "final_error_m") return FinalError();
    if (name == "goal_error_m") return GoalError();
    throw Error("there is no measure " + name);
  }

  void RequireDriven() const {
    for (const RobotTrack& robot : seen_.robots) {
      if (robot.distance >= kLeastDriven) continue;
      throw Error(fmt::format("{} drove {:.2f} m, and who does not drive {} m has shown nothing",
                              robot.name, robot.distance, kLeastDriven));
    }
  }

  double Clumsiness(const std::string& name) const {
    RequireDriven();
    if (name == "contacts") {
      return Worst([](const RobotTrack& robot) { return static_cast<double>(robot.contacts); });
    }
    if (name == "contact_s")
      return Worst([](const RobotTrack& robot) { return robot.contact_time; });
    return Worst([](const RobotTrack& robot) { return StuckTime(robot.samples); });
  }

  double Gap() const {
    RequireDriven();
    if (seen_.robots.size() < 2) throw Error("there is only one robot");
    return seen_.gap;
  }

  double Coverage() const {
    const Vec2 start{Samples().front().pose.x, Samples().front().pose.y};
    const Grid floor = ReachableFloor(info_.scenario.world, start);
    Grid middles(floor.width, floor.height);
    for (std::size_t i = 0; i < Samples().size(); ++i) {
      // Straight from sample to sample, so that a fast robot leaves no holes.
      const Pose2& to = Samples()[i].pose;
      const Pose2& from = Samples()[i == 0 ? 0 : i - 1].pose;
      const int steps =
          1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / (kCell / 2));
      for (int k = 1; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps;
        middles.Set(CellOf({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}));
      }
    }
    const Grid covered = Grown(middles, kDilation);
    int visited = 0;
    for (std::size_t i = 0; i < floor.cells.size(); ++i) {
      visited += floor.cells[i] != 0 && covered.cells[i] != 0 ? 1 : 0;
    }
    const int all = floor.Count();
    return all == 0 ? 0.0 : static_cast<double>(visited) / all;
  }

  const TimedAnswer& Answer(const char* name) const {
    const auto found = seen_.answers.find(name);
    if (found == seen_.answers.end()) {
      throw Error(fmt::format("the program handed in no \"{}\"", name));
    }
    return found->second;
  }

  const std::vector<Vec2>& Path() {
    if (judgement_.path.empty()) {
      try {
        judgement_.path = ReadPath(Answer("path").text);
      } catch (const Error& error) {
        const bool missing = !seen_.answers.contains("path");
        throw Error(missing ? error.what() : fmt::format("the path is no good: {}", error.what()));
      }
    }
    return judgement_.path;
  }

  const Route& TheRoute() {
    if (!judgement_.route) judgement_.route = DrawRoute(info_.scenario);
    if (!judgement_.route) throw Error("there is nowhere to plan to in this world");
    return *judgement_.route;
  }

  // The share of the path that lies in free cells; 0 where it does not lead from start to goal.
  double PathValid() {
    const std::vector<Vec2>& path = Path();
    const Route& route = TheRoute();
    const auto off = [](Vec2 point, Cell cell) {
      const Vec2 to = MiddleOf(cell);
      return std::hypot(point.x - to.x, point.y - to.y);
    };
    if (off(path.front(), route.start) > kEndTolerance) {
      throw Error(
          fmt::format("the path begins {:.2f} m from the start", off(path.front(), route.start)));
    }
    if (off(path.back(), route.goal) > kEndTolerance) {
      throw Error(
          fmt::format("the path ends {:.2f} m from the goal", off(path.back(), route.goal)));
    }
    const Grid free = Inverted(Grown(PlannersMap(info_.scenario.world), kDilation));
    std::int64_t all = 0;
    std::int64_t good = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Vec2 from = path[i == 0 ? 0 : i - 1];
      const Vec2 along = path[i] - from;
      // Samples a twentieth of a cell apart, of which none is on a corner of four cells alone.
      const double length = std::hypot(along.x, along.y);
      const auto steps = static_cast<std::int64_t>(std::min(length / (kCell / 20.0), 1e7)) + 1;
      for (std::int64_t k = 0; k < steps; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
        ++all;
        good += free.Has(CellOf(from + share * along)) ? 1 : 0;
      }
    }
    return static_cast<double>(good) / static_cast<double>(all);
  }

  double LengthRatio() {
    if (PathValid() < 0.99) throw Error("a path through walls has no length to be compared");
    const Grid free = Inverted(Grown(PlannersMap(info_.scenario.world), kDilation));
    const double best = ShortestWay(free, TheRoute().start, TheRoute().goal) * kCell;
    return LengthOf(Path()) / best;
  }

  double Turning() {
    if (PathValid() < 0.99) throw Error("a path through walls has no turns to be counted");
    double turned = 0.0;
    std::optional<double> before;
    for (std::size_t i = 1; i < Path().size(); ++i) {
      const Vec2 along = Path()[i] - Path()[i - 1];
      if (std::hypot(along.x, along.y) < 1e-9) continue;
      const double heading = std::atan2(along.y, along.x);
      if (before) turned += std::fabs(NormalizeAngle(heading - *before));
      before = heading;
    }
    return turned / std::max(LengthOf(Path()), kCell);
  }

  const MapScores& Map() {
    if (map_) return *map_;
    const std::string& text = Answer("map").text;
    MapAnswer map;
    try {
      map = ReadMap(text);
    } catch (const Error& error) {
      throw Error(fmt::format("the map is no good: {}", error.what()));
    }
    const Vec2 start{Samples().front().pose.x, Samples().front().pose.y};
    const scene::World& world = info_.scenario.world;
    return map_.emplace(CompareMap(map, world, ReachableFloor(world, start)));
  }

  // From when the robot first was as far from a wall as it is to be, or 10 s have gone by.
  double WallError() const {
    RequireDriven();
    constexpr double kLongestApproach = 10.0;
    const double wanted = *rubric_.reference.wall_distance_m;
    double sum = 0.0;
    int count = 0;
    bool there = false;
    double before = Samples().front().nearest - wanted;
    for (const Sample& sample : Samples()) {
      const double error = sample.nearest - wanted;
      there = there || error * before <= 0.0 || sample.time >= kLongestApproach;
      before = error;
      if (!there) continue;
      sum += error * error;
      ++count;
    }
    if (count == 0) throw Error("the robot never came to the wall");
    return std::sqrt(sum / count);
  }

  double Overshoot() const {
    RequireDriven();
    const double wanted = *rubric_.reference.wall_distance_m;
    const double first = Samples().front().nearest - wanted;
    if (std::fabs(first) < 1e-3) throw Error("the robot starts where it is to go");
    double beyond = 0.0;
    bool there = false;
    for (const Sample& sample : Samples()) {
      const double side = (sample.nearest - wanted) / first;  // 1 at the start, below 0 beyond
      there = there || side <= 0.05;
      beyond = std::max(beyond, -side);
    }
    if (!there) throw Error("the robot never came to where it is to go");
    return beyond;
  }

  double TrackingError() const {
    RequireDriven();
    double sum = 0.0;
    for (const Sample& sample : Samples()) {
      const double off = LineDistance(rubric_.reference.trajectory, {sample.pose.x, sample.pose.y});
      sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(Samples().size()));
  }

  double FinalError() const {
    const TimedAnswer& answer = Answer("pose");
    Pose2 said;
    try {
      said = ReadPose(answer.text);
    } catch (const Error& error) {
      throw Error(fmt::format("the pose is no good: {}", error.what()));
    }
    return std::hypot(said.x - answer.pose.x, said.y - answer.pose.y);
  }

  // The smallest mean over all choices of moments in order.
  double GoalError() const {
    RequireDriven();
    const std::vector<Vec2>& goals = rubric_.reference.goals;
    std::vector<double> best(Samples().size(), 0.0);
    for (const Vec2& goal : goals) {
      double least = kEndless;
      double before = kEndless;
      for (std::size_t i = 0; i < Samples().size(); ++i) {
        before = std::min(before, best[i]);
        const Pose2& pose = Samples()[i].pose;
        least = std::min(least, before + std::hypot(pose.x - goal.x, pose.y - goal.y));
        best[i] = least;
      }
    }
    return best.back() / static_cast<double>(goals.size());
  }

  const Rubric& rubric_;
  const servers::RecordInfo& info_;
  const Evidence& seen_;
  Judgement& judgement_;
  std::map<std::string, MeasureValue> known_;
  std::optional<MapScores> map_;
};

CriterionResult JudgeCriterion(const Criterion& criterion, Measures& measures) {
  CriterionResult result{criterion.name, criterion.measure, criterion.weight, 0.0, {}, {}};
  const MeasureValue& measured = measures.Of(criterion.measure);
  result.value = measured.value;
  if (!measured.value) {
    result.reason = measured.why;
  } else {
    result.points = Points(criterion, *measured.value);
  }
  if (criterion.only_if && measured.value) {
    const MeasureValue& needed = measures.Of(criterion.only_if->measure);
    if (!needed.value || *needed.value < criterion.only_if->least) {
      result.points = 0.0;
      result.reason = fmt::format("counts only with {} of {} or more, and it was {}",
                                  criterion.only_if->measure, criterion.only_if->least,
                                  needed.value ? fmt::format("{:.3g}", *needed.value) : "none");
    }
  }
  // The hint is about what was measured, and would contradict why nothing was.
  if (result.reason.empty() && result.points < criterion.weight * 0.999) {
    result.reason = criterion.hint;
  }
  return result;
}

}  // namespace

Judgement Judge(const Rubric& rubric, const std::string& record) {
  servers::Replay replay(record);
  Judgement judgement;
  judgement.seed = replay.info().scenario.seed;
  if (replay.simulation().robots().empty()) {
    throw servers::RecordError("the record " + record + " has no robot to be judged");
  }
  const std::uint64_t blank = replay.simulation().canvas().revision();
  Watch watch(replay);
  watch.Before();
  watch.Look();
  for (;;) {
    watch.Before();
    if (!replay.Step()) break;
    watch.Look();
  }
  if (const auto& difference = replay.difference()) {
    throw servers::RecordError(fmt::format(
        "the record {} is not what this ccmorse makes of its inputs (tick {}, {}), so it proves "
        "nothing; it was made by version {}",
        record, difference->last_tick,
        difference->component.empty() ? "state" : difference->component, replay.info().version));
  }
  judgement.seconds = replay.simulation().time();
  judgement.hash = replay.simulation().Hash();
  judgement.world = replay.simulation().world().scene();
  const Evidence seen = watch.End();
  judgement.robots = seen.robots;

  Measures measures(rubric, replay.info(), seen, judgement);
  for (const Criterion& criterion : rubric.criteria) {
    judgement.criteria.push_back(JudgeCriterion(criterion, measures));
  }
  const auto& refusals = replay.directory().refusals();
  if (!refusals.empty()) {
    judgement.refused =
        fmt::format("at {:.2f} s the program called {} {}, which is not for robots' programs",
                    static_cast<double>(refusals[0].tick) / replay.info().scenario.time.frequency,
                    refusals[0].component, refusals[0].service);
  } else if (replay.info().ticks == 0 && seen.answers.empty() &&
             replay.simulation().canvas().revision() == blank) {
    // One that only draws and asks once, as a planner may, was there.
    judgement.refused =
        "the program never asked for the robot's data, so no simulated time went by: does it "
        "connect to the given host and port, and call Read()?";
  }
  for (CriterionResult& result : judgement.criteria) {
    if (!judgement.refused.empty()) {
      result.points = 0.0;
      result.reason = judgement.refused;
    }
    judgement.score += result.points;
  }
  return judgement;
}

}  // namespace ccmorse::grade
