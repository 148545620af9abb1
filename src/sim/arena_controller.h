#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/scenario.h"
#include "sim/component.h"
#include "sim/robots/robot.h"
#include "sim/state_hash.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// Raises, lowers and moves a world's dynamic boxes during a run: by request, from presets, by time
/// and by where robots are (thesis 5.1, N01 to N04). No box ever comes up under a robot or runs
/// into one: it waits until the robot is gone. Not thread safe.
class ArenaController {
 public:
  /// Both outlive it.
  ArenaController(World& world, const std::vector<std::unique_ptr<Robot>>& robots,
                  const scene::ObstacleRules& rules);

  /// Does it all; throws Error on an unknown preset, or an id that is no dynamic box, before
  /// anything happens. `cause` is for events().
  void Apply(const scene::ObstacleAction& action, double time, const std::string& cause);
  /// Puts a dynamic box somewhere; throws Error when it is none, or would overlap a robot.
  void Move(int box, const Pose2& pose, double time);

  const std::map<std::string, std::vector<int>>& presets() const { return rules_.presets; }
  /// Keeps what is up now under `name`, in place of what was there.
  void SavePreset(const std::string& name);
  const scene::ObstacleRules& rules() const { return rules_; }
  void Add(scene::ObstacleTimer timer);
  void Add(scene::ObstacleTrap trap);

  /// Boxes that are to come up as soon as no robot stands there, sorted.
  const std::vector<int>& waiting() const { return waiting_; }

  /// Something that happened, by whose doing.
  struct Event {
    double time = 0.0;  ///< s, simulated
    std::string cause;  ///< "service", "timer", "trap door by s1r"
    std::string what;   ///< "up 69, 70", "down 5", "say ..."
  };
  /// The last of them, at most 200.
  const std::deque<Event>& events() const { return events_; }
  std::uint64_t event_count() const { return event_count_; }

  /// One tick, after the robots have moved; `now` is the tick's instant.
  void Step(const Instant& now);

  /// Boxes and traps as at the start, but presets that were saved stay. To be called after the
  /// robots were put where they start.
  void Reset();

  /// All that ever happened to boxes; 0 while nothing has.
  std::uint64_t hash() const { return changed_ ? hash_.value() : 0; }

 private:
  void CheckIds(const std::vector<int>& ids) const;
  bool IsFree(const scene::Box& box, const Pose2& pose) const;
  void Want(int box, bool up);
  void Set(int box, bool up);
  void RaiseWaiting();
  void Follow(std::size_t number, const Instant& now);
  void Note(double time, const std::string& cause, std::string what);

  World& world_;
  const std::vector<std::unique_ptr<Robot>>& robots_;
  scene::ObstacleRules rules_;
  std::vector<scene::Box> boxes_at_start_;
  std::vector<std::uint64_t> timer_rounds_;    // how often each has rung
  std::vector<std::vector<bool>> trap_holds_;  // by trap and robot: it is in the region
  std::vector<bool> trap_sprung_;
  std::vector<double> path_delays_;  // s that each path's box has waited
  std::vector<int> waiting_;
  std::deque<Event> events_;
  std::uint64_t event_count_ = 0;
  StateHash hash_;
  bool changed_ = false;
};

}  // namespace ccmorse::sim
