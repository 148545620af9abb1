#include "sim/arena_controller.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "base/nearest_name.h"
#include "base/polygon.h"
#include "base/trig.h"

namespace ccmorse::sim {
namespace {

constexpr std::size_t kMostEvents = 200;

// By the number of edges that a ray to the right crosses; the corners may go round either way.
bool Inside(std::span<const Vec2> region, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Vec2& a = region[i];
    const Vec2& b = region[(i + 1) % region.size()];
    if ((a.y > y) == (b.y > y)) continue;
    if (x < a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

std::string Listed(const char* what, const std::vector<int>& ids) {
  std::string text = what;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    text += (i == 0 ? " " : ", ") + std::to_string(ids[i]);
  }
  return text;
}

}  // namespace

ArenaController::ArenaController(World& world, const std::vector<std::unique_ptr<Robot>>& robots,
                                 const scene::ObstacleRules& rules)
    : world_(world), robots_(robots), rules_(rules) {
  for (const scene::Box& box : world.scene().boxes) {
    if (box.dynamic) boxes_at_start_.push_back(box);
  }
  timer_rounds_.resize(rules_.timers.size());
  trap_holds_.resize(rules_.traps.size());
  trap_sprung_.resize(rules_.traps.size());
  path_delays_.resize(rules_.paths.size());
}

void ArenaController::CheckIds(const std::vector<int>& ids) const {
  for (const int id : ids) {
    const scene::Box* const box = world_.FindBox(id);
    if (box == nullptr) throw Error("the world has no box with id " + std::to_string(id));
    if (!box->dynamic) {
      throw Error("box " + std::to_string(id) + " is " + box->kind + " and cannot be moved");
    }
  }
}

void ArenaController::Apply(const scene::ObstacleAction& action, double time,
                            const std::string& cause) {
  for (const auto* ids : {&action.up, &action.down, &action.toggle}) CheckIds(*ids);
  if (!action.preset.empty()) {
    const auto preset = rules_.presets.find(action.preset);
    if (preset == rules_.presets.end()) {
      std::vector<std::string> known;
      for (const auto& [name, ids] : rules_.presets) known.push_back(name);
      throw Error("there is no preset '" + action.preset + "'" + DidYouMean(action.preset, known));
    }
    const std::vector<int>& up = preset->second;
    for (const scene::Box& box : boxes_at_start_) {
      Want(box.id, std::find(up.begin(), up.end(), box.id) != up.end());
    }
    Note(time, cause, "preset " + action.preset);
  }
  for (const int id : action.up) Want(id, true);
  for (const int id : action.down) Want(id, false);
  for (const int id : action.toggle) {
    const bool waits = std::binary_search(waiting_.begin(), waiting_.end(), id);
    Want(id, !waits && !world_.FindBox(id)->raised);
  }
  if (!action.up.empty()) Note(time, cause, Listed("up", action.up));
  if (!action.down.empty()) Note(time, cause, Listed("down", action.down));
  if (!action.toggle.empty()) Note(time, cause, Listed("toggle", action.toggle));
  if (!action.say.empty()) Note(time, cause, "say " + action.say);
}

void ArenaController::Move(int box_id, const Pose2& pose, double time) {
  CheckIds({box_id});
  const scene::Box& box = *world_.FindBox(box_id);
  if (box.raised && !IsFree(box, pose)) {
    throw Error("box " + std::to_string(box_id) + " does not fit there: a robot is in its way");
  }
  world_.SetBoxPose(box_id, pose);
  changed_ = true;
  hash_.Add(static_cast<std::uint64_t>(box_id));
  for (const double number : {pose.x, pose.y, pose.yaw}) hash_.Add(number);
  Note(time, "service", "move " + std::to_string(box_id));
}

void ArenaController::SavePreset(const std::string& name) {
  std::vector<int>& up = rules_.presets[name];
  up.clear();
  for (const scene::Box& box : world_.scene().boxes) {
    const bool waits = std::binary_search(waiting_.begin(), waiting_.end(), box.id);
    if (box.dynamic && (box.raised || waits)) up.push_back(box.id);
  }
}

void ArenaController::Add(scene::ObstacleTimer timer) {
  rules_.timers.push_back(std::move(timer));
  timer_rounds_.push_back(0);
}

void ArenaController::Add(scene::ObstacleTrap trap) {
  rules_.traps.push_back(std::move(trap));
  trap_holds_.emplace_back();
  trap_sprung_.push_back(false);
}

bool ArenaController::IsFree(const scene::Box& box, const Pose2& pose) const {
  if (!box.solid) return true;
  const auto corners = BoxCorners(pose, box.size_x, box.size_y);
  const Obstacle there = Obstacle::Make({corners.begin(), corners.end()}, box.id);
  const std::array<const Obstacle*, 1> one = {&there};
  return std::none_of(robots_.begin(), robots_.end(), [&one](const auto& robot) {
    return Collides(robot->footprint(), robot->pose(), one);
  });
}

void ArenaController::Want(int box, bool up) {
  const auto waits = std::lower_bound(waiting_.begin(), waiting_.end(), box);
  const bool is_waiting = waits != waiting_.end() && *waits == box;
  const scene::Box& now = *world_.FindBox(box);
  if (!up) {
    if (is_waiting) waiting_.erase(waits);
    if (now.raised) Set(box, false);
  } else if (!now.raised) {
    if (IsFree(now, now.pose)) {
      if (is_waiting) waiting_.erase(waits);
      Set(box, true);
    } else if (!is_waiting) {
      waiting_.insert(waits, box);
    }
  }
}

void ArenaController::Set(int box, bool up) {
  world_.SetRaised(box, up);
  changed_ = true;
  hash_.Add(2 * static_cast<std::uint64_t>(box) + (up ? 1 : 0));
}

void ArenaController::RaiseWaiting() {
  const std::vector<int> boxes = waiting_;
  for (const int box : boxes) Want(box, true);
}

void ArenaController::Step(const Instant& now) {
  const double half = now.step / 2.0;
  for (std::size_t i = 0; i < rules_.timers.size(); ++i) {
    const scene::ObstacleTimer& timer = rules_.timers[i];
    if (timer.every <= 0.0 && timer_rounds_[i] > 0) continue;
    const double due = timer.at + static_cast<double>(timer_rounds_[i]) * timer.every;
    if (now.time < due - half) continue;
    // One that was added late, or rings more often than there are ticks, does so once.
    timer_rounds_[i] =
        timer.every > 0.0
            ? static_cast<std::uint64_t>((now.time + half - timer.at) / timer.every) + 1
            : 1;
    Apply(timer.action, now.time, "timer");
  }
  for (std::size_t i = 0; i < rules_.traps.size(); ++i) {
    const scene::ObstacleTrap& trap = rules_.traps[i];
    trap_holds_[i].resize(robots_.size());
    for (std::size_t k = 0; k < robots_.size(); ++k) {
      const Robot& robot = *robots_[k];
      if (!trap.robot.empty() && robot.name() != trap.robot) continue;
      const bool inside = Inside(trap.region, robot.pose().x, robot.pose().y);
      const bool came = inside && !trap_holds_[i][k];
      trap_holds_[i][k] = inside;
      if (!came || (trap.once && trap_sprung_[i])) continue;
      trap_sprung_[i] = true;
      Apply(trap.action, now.time, "trap " + trap.name + " by " + robot.name());
    }
  }
  for (std::size_t i = 0; i < rules_.paths.size(); ++i) Follow(i, now);
  if (!waiting_.empty()) RaiseWaiting();
}

void ArenaController::Follow(std::size_t number, const Instant& now) {
  const scene::ObstaclePath& path = rules_.paths[number];
  const double first = path.points.front().time;
  const double last = path.points.back().time;
  double time = now.time + now.step - path_delays_[number];
  if (time <= first) return;
  if (path.repeat) time = first + std::fmod(time - first, last - first);
  std::size_t i = 1;
  while (i + 1 < path.points.size() && path.points[i].time < time) ++i;
  const auto& [from_time, from] = path.points[i - 1];
  const auto& [to_time, to] = path.points[i];
  const double part = std::clamp((time - from_time) / (to_time - from_time), 0.0, 1.0);
  const Pose2 pose{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y),
                   NormalizeAngle(from.yaw + part * NormalizeAngle(to.yaw - from.yaw))};
  const scene::Box& box = *world_.FindBox(path.box);
  if (pose.x == box.pose.x && pose.y == box.pose.y && pose.yaw == box.pose.yaw) return;
  if (box.raised && !IsFree(box, pose)) {
    path_delays_[number] += now.step;  // it goes on from here
    return;
  }
  world_.SetBoxPose(path.box, pose);
  changed_ = true;
  hash_.Add(static_cast<std::uint64_t>(path.box));
  for (const double value : {pose.x, pose.y, pose.yaw}) hash_.Add(value);
}

void ArenaController::Reset() {
  waiting_.clear();
  trap_holds_.assign(rules_.traps.size(), {});
  trap_sprung_.assign(rules_.traps.size(), false);
  for (const scene::Box& box : boxes_at_start_) {
    const scene::Box& now = *world_.FindBox(box.id);
    const bool elsewhere =
        now.pose.x != box.pose.x || now.pose.y != box.pose.y || now.pose.yaw != box.pose.yaw;
    if (elsewhere) world_.SetBoxPose(box.id, box.pose);
    if (now.raised != box.raised) Set(box.id, box.raised);
  }
}

void ArenaController::Note(double time, const std::string& cause, std::string what) {
  ++event_count_;
  // What a scenario says is for people; a toggling obstacle would flood them.
  const bool said = what.starts_with("say ");
  LogLine(said ? LogLevel::kInfo : LogLevel::kDebug,
          fmt::format("obstacles at {:.3f} s: {} ({})", time, what, cause));
  events_.push_back({time, cause, std::move(what)});
  if (events_.size() > kMostEvents) events_.pop_front();
}

}  // namespace ccmorse::sim
