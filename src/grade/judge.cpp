#include "grade/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/line_cells.h"
#include "base/polygon.h"
#include "base/trig.h"
#include "grade/map_answer.h"
#include "servers/record/replay.h"
#include "sim/actuators/answers.h"
#include "sim/sensors/laser_scanner.h"

namespace ccmorse::grade {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kStuckTime = 5.0;       // s
constexpr double kStuckWay = 0.05;       // m
constexpr double kLeastDriven = 0.5;     // m, of who is to be praised for touching nothing
constexpr double kEndTolerance = 0.045;  // m, of a path's ends: a cell and its neighbours
constexpr double kTimeSlack = 0.5;       // s before the limit that still count as its end

// All that is looked at while the record is simulated again.
struct Evidence {
  std::vector<RobotTrack> robots;
  std::map<std::string, std::string> answers;  // the first robot's, as JSON
  Pose2 end;                                   // of the first robot
  double gap = kEndless;                       // m, smallest between two robots
  Grid seen{0, 0};                             // by the first robot's lasers; empty: not asked for
};

std::vector<Vec2> FootprintAt(const sim::Robot& robot) {
  std::vector<Vec2> placed(robot.model().footprint.size());
  Place(robot.model().footprint, robot.pose(), placed);
  return placed;
}

class Watch {
 public:
  // `sight`: note what the first robot's lasers see, too.
  Watch(const servers::Replay& replay, bool sight)
      : replay_(replay),
        every_(std::max<std::uint64_t>(
            1, static_cast<std::uint64_t>(
                   std::lround(kSampleTime * replay.info().scenario.time.frequency)))) {
    for (const auto& robot : Sim().robots()) seen_.robots.push_back({robot->name(), {}, 0, 0, 0});
    if (!sight) return;
    const Grid walls = Walls(Sim().world().scene(), 0.0);
    seen_.seen = Grid(walls.width, walls.height);
    for (const auto& component : Sim().robots().front()->components()) {
      const auto* const laser = dynamic_cast<const sim::LaserScanner*>(component.get());
      // Before the first scan there is nothing, which is not a free view.
      if (laser != nullptr) lasers_.emplace_back(laser, laser->timestamp());
    }
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
    for (auto& [laser, looked] : lasers_) {
      if (laser->timestamp() == looked) continue;
      looked = laser->timestamp();
      TakeScan(*laser);
    }
  }

  Evidence End() {
    TakeAnswers();
    // Between the beams of a scan lies as much as a cell.
    if (seen_.seen.width > 0) seen_.seen = Grown(seen_.seen, 1);
    for (std::size_t i = 0; i < Sim().robots().size(); ++i) {
      const sim::RobotTally& tally = Sim().robots()[i]->tally();
      seen_.robots[i].distance = tally.distance;
      seen_.robots[i].contacts = tally.contacts;
      seen_.robots[i].contact_time = tally.stalled;
    }
    if (!Sim().robots().empty()) seen_.end = Sim().robots().front()->pose();
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
      if (answer.revision > revision_) seen_.answers[name] = answer.text;
    }
    revision_ = answers->revision();
  }

  // The cells that the beams of the tick's scan crossed, and those where they ended; a scan shows
  // where the robot was when the tick began. And where the robot stands it has been.
  void TakeScan(const sim::LaserScanner& laser) {
    const sim::BeamFan& fan = laser.fan();
    const Vec2 from = Transform(before_, {fan.position().x, fan.position().y});
    const Cell start = CellOf(from);
    const auto [sine, cosine] = SinCos(before_.yaw);
    for (std::size_t i = 0; i < fan.count(); ++i) {
      const Vec3 own = Rotate(fan.rotation(), fan.Direction(i));
      const Vec2 along{cosine * own.x - sine * own.y, sine * own.x + cosine * own.y};
      const double range = laser.ranges()[i];
      const Cell end = CellOf(from + range * along);
      ForEachLineCell(start.x, start.y, end.x, end.y, seen_.seen.width, seen_.seen.height,
                      [this](int x, int y) {
                        seen_.seen.Set({x, y});
                      });
    }
    const Cell middle = CellOf({before_.x, before_.y});
    for (int dy = -kDilation; dy <= kDilation; ++dy) {
      for (int dx = -kDilation; dx <= kDilation; ++dx) {
        if (dx * dx + dy * dy > kDilation * kDilation) continue;
        seen_.seen.Set({middle.x + dx, middle.y + dy});
      }
    }
  }

 public:
  // The sensors of a tick see what is at its start.
  void Before() {
    if (!Sim().robots().empty()) before_ = Sim().robots().front()->pose();
  }

 private:
  const servers::Replay& replay_;
  std::uint64_t every_;
  Evidence seen_;
  std::uint64_t revision_ = 0;
  Pose2 before_;
  std::vector<std::pair<const sim::LaserScanner*, double>> lasers_;  // and when they last looked, s
};

// What is only told from what the robot saw.
bool NeedsSight(const std::string& measure) {
  return measure == "explored" || measure == "cell_accuracy" || measure == "map_iou";
}

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
    if (name == "explored") return Explored();
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

  double Coverage() {
    Grid middles(Floor().width, Floor().height);
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
    return ShareOfFloor(Grown(middles, kDilation));
  }

  // What the robot could come to from its start.
  const Grid& Floor() {
    if (!floor_) {
      const Vec2 start{Samples().front().pose.x, Samples().front().pose.y};
      floor_ = ReachableFloor(info_.scenario.world, start);
    }
    return *floor_;
  }

  // The share of it that is set in `cells`.
  double ShareOfFloor(const Grid& cells) {
    int set = 0;
    for (std::size_t i = 0; i < Floor().cells.size(); ++i) {
      set += Floor().cells[i] != 0 && cells.cells[i] != 0 ? 1 : 0;
    }
    const int all = Floor().Count();
    return all == 0 ? 0.0 : static_cast<double>(set) / all;
  }

  const std::string& Answer(const char* name) const {
    const auto found = seen_.answers.find(name);
    if (found == seen_.answers.end()) {
      throw Error(fmt::format("the program handed in no \"{}\"", name));
    }
    return found->second;
  }

  const std::vector<Vec2>& Path() {
    if (judgement_.path.empty()) {
      try {
        judgement_.path = ReadPath(Answer("path"));
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

  // 1 less what of the path lies in no free cell, as a share of the shortest way: not of the path's
  // own length, which a detour would make as long as wanted.
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
    double blocked = 0.0;  // m
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Vec2 along = path[i] - path[i - 1];
      // Samples a twentieth of a cell apart, of which none is on a corner of four cells alone.
      const double length = std::hypot(along.x, along.y);
      const auto steps = static_cast<std::int64_t>(std::min(length / (kCell / 20.0), 1e7)) + 1;
      const double step = length / static_cast<double>(steps);
      for (std::int64_t k = 0; k < steps; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(steps);
        if (!free.Has(CellOf(path[i - 1] + share * along))) blocked += step;
      }
    }
    best_length_ = ShortestWay(free, route.start, route.goal) * kCell;
    return std::max(0.0, 1.0 - blocked / best_length_);
  }

  // `why`: what there is not of a path that is not valid. Afterwards best_length_ is known.
  void RequireValidPath(const char* why) {
    const MeasureValue& valid = Of("path_valid");
    if (!valid.value) throw Error(valid.why);
    if (*valid.value < 0.99) throw Error(why);
  }

  double LengthRatio() {
    RequireValidPath("a path through walls has no length to be compared");
    return LengthOf(Path()) / best_length_;
  }

  double Turning() {
    RequireValidPath("a path through walls has no turns to be counted");
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
    const std::string& text = Answer("map");
    MapAnswer map;
    try {
      map = ReadMap(text);
    } catch (const Error& error) {
      throw Error(fmt::format("the map is no good: {}", error.what()));
    }
    const scene::World& world = info_.scenario.world;
    judgement_.map = PictureOf(map, world, seen_.seen);
    return map_.emplace(CompareMap(map, world, Floor(), seen_.seen));
  }

  double Explored() { return ShareOfFloor(seen_.seen); }

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
    const std::string& answer = Answer("pose");
    Pose2 said;
    try {
      said = ReadPose(answer);
    } catch (const Error& error) {
      throw Error(fmt::format("the pose is no good: {}", error.what()));
    }
    return std::hypot(said.x - seen_.end.x, said.y - seen_.end.y);
  }

  // Of the robot that did worst.
  double GoalError() const {
    RequireDriven();
    double worst = 0.0;
    for (const auto& entry : rubric_.reference.goals) {
      const std::string& name = entry.first;
      const auto robot = std::find_if(
          seen_.robots.begin(), seen_.robots.end(),
          [&name](const RobotTrack& track) { return name.empty() || track.name == name; });
      if (robot == seen_.robots.end()) throw Error("there is no robot " + name + " with a goal");
      worst = std::max(worst, GoalError(entry.second, robot->samples));
    }
    return worst;
  }

  // The smallest mean over all choices of moments in order.
  static double GoalError(const std::vector<Vec2>& goals, const std::vector<Sample>& samples) {
    std::vector<double> best(samples.size(), 0.0);
    for (const Vec2& goal : goals) {
      double least = kEndless;
      double before = kEndless;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        before = std::min(before, best[i]);
        const Pose2& pose = samples[i].pose;
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
  std::optional<Grid> floor_;
  double best_length_ = 0.0;  // m, of the oracle's way
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
  for (const Criterion::Condition& condition : criterion.only_if) {
    if (!measured.value) break;
    const MeasureValue& needed = measures.Of(condition.measure);
    const bool low = needed.value && *needed.value < condition.least;
    const bool high = needed.value && *needed.value > condition.most;
    if (needed.value && !low && !high) continue;
    const bool least = low || (!high && std::isfinite(condition.least));
    result.points = 0.0;
    result.reason = fmt::format("counts only with {} of {} or {}, and it was {}", condition.measure,
                                least ? condition.least : condition.most, least ? "more" : "less",
                                needed.value ? fmt::format("{:.3g}", *needed.value) : "none");
    break;
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
  const bool sight =
      std::any_of(rubric.criteria.begin(), rubric.criteria.end(), [](const Criterion& criterion) {
        return NeedsSight(criterion.measure) ||
               std::any_of(criterion.only_if.begin(), criterion.only_if.end(),
                           [](const auto& condition) { return NeedsSight(condition.measure); });
      });
  Watch watch(replay, sight);
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
