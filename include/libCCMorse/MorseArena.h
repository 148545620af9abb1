#pragma once

#include <map>
#include <string>
#include <vector>

#include "libCCMorse/MorseClient.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

/// A dynamic obstacle of the arena.
struct MorseObstacle {
  int id = 0;
  std::string kind;      ///< in SyRoTek's arena "dynamic_slab" or "dynamic_pillar"
  player_pose2d_t pose;  ///< of its centre, m and rad
  double size_x = 0.0;   ///< m, along its own x
  double size_y = 0.0;   ///< m, along its own y
  double height = 0.0;   ///< m, when it is up
  bool raised = false;   ///< it stands
  bool waiting = false;  ///< it comes up as soon as no robot stands there
};

/// What is done to obstacles at once: first the preset, then the lists.
struct MorseObstacleAction {
  std::string preset;       ///< a name of GetPresets(); "": none
  std::vector<int> up;      ///< ids that rise
  std::vector<int> down;    ///< ids that go down
  std::vector<int> toggle;  ///< ids that do the one or the other
  std::string say;          ///< a line for the simulator's log; "": none
};

/// The arena controller (thesis 5.1, checklist N01 to N04): raises, lowers and moves the dynamic
/// obstacles of a ccmorse simulation. Where a robot stands nothing comes up: the obstacle waits
/// until it is gone. Keeps the client object alive; any thread. Each call is a request of its own:
/// see MorseClient::Request() for what it throws; a simulator that has no arena controller, such as
/// MORSE, answers with a MorseError.
class MorseArena {
 public:
  explicit MorseArena(MorseClient& client);

  std::vector<MorseObstacle> GetObstacles() const;  ///< the dynamic ones, by id
  bool IsRaised(int id) const;                      ///< MorseError where there is no such obstacle

  // --- Each returns the ids that wait for a robot to leave. MorseError for ids that are no dynamic
  // obstacles; then nothing happens.
  std::vector<int> Raise(const std::vector<int>& ids);
  std::vector<int> Lower(const std::vector<int>& ids);
  std::vector<int> Toggle(const std::vector<int>& ids);

  /// Puts an obstacle somewhere else, m and rad. MorseError when a robot is in its way.
  void Move(int id, const player_pose2d_t& pose);

  /// Sets of obstacles that are up while all others are down, by name (N02).
  std::map<std::string, std::vector<int>> GetPresets() const;
  /// Returns the ids that wait. MorseError for an unknown name.
  std::vector<int> LoadPreset(const std::string& name);
  /// Keeps what is up now; returns its ids.
  std::vector<int> SavePreset(const std::string& name);

  /// Does something when simulated time is `at`, s, and, where `every` (s) is above 0, again and
  /// again (N03). A time that is over counts as now.
  void AddTimer(double at, const MorseObstacleAction& action, double every = 0.0);
  /// Does something whenever the robot named `robot` ("": any) comes into the polygon with the
  /// given corners, m; `once`: the first time only (N04).
  void AddTrap(const std::string& name, const std::vector<player_point_2d_t>& corners,
               const MorseObstacleAction& action, const std::string& robot = "", bool once = false);

 private:
  std::vector<int> Change(const char* service, const std::vector<int>& ids);
  std::shared_ptr<MorseClient> client_;
};

}  // namespace CCMorse
