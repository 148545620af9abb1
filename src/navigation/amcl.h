#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/pose.h"
#include "base/trig.h"
#include "navigation/occupancy_grid.h"
#include "navigation/scan.h"

namespace ccmorse::navigation {

/// Settings of Player's driver "amcl" (specs: player.md G.5), with its names. Where the scanner
/// sits (laser_pose) comes with each scan. What Player calls "var" are standard deviations.
struct AmclOptions {
  bool odom_init = true;       ///< use the odometry; without it the particles stay where they are
  int pf_min_samples = 100;    ///< particles at least, > 0
  int pf_max_samples = 10000;  ///< particles at most, and at the start
  double pf_err = 0.01;        ///< KLD sampling: error between true and estimated density, > 0
  double pf_z = 3.0;           ///< KLD sampling: quantile of how sure that is, > 0
  std::array<double, 3> kld_bin = {0.5, 0.5, Radians(10.0)};    ///< m, m, rad: a bin of it, > 0
  Pose2 init_pose;                                              ///< m and rad
  std::array<double, 3> init_pose_var = {1.0, 1.0, 2.0 * kPi};  ///< m, m, rad, >= 0
  std::array<double, 2> update_thresh = {0.2, kPi / 6.0};       ///< m, rad: works after such a move
  /// Standard deviation of a move's forward, sideways and turning error for each metre forward,
  /// metre sideways and radian of turn, >= 0.
  std::array<std::array<double, 3>, 3> odom_drift = {
      {{0.2, 0.0, 0.0}, {0.0, 0.2, 0.0}, {0.2, 0.0, 0.2}}};
  int laser_max_beams = 6;         ///< beams used of a scan, spread over it, >= 2
  double laser_range_max = 8.192;  ///< m, > 0: longer ranges are no return
  double laser_range_var = 0.1;    ///< m, > 0, of a range; the map's error included
  double laser_range_bad = 0.1;    ///< share of ranges that mean nothing, (0, 1)
  std::uint64_t seed = 1;          ///< of all random numbers
};

/// Settings that suit the S1R of SyRoTek and its arena.
AmclOptions AmclOptionsForS1r();

/// Where the robot may be: a cluster of particles.
struct AmclHypothesis {
  Pose2 mean;                          ///< m and rad, in the map's frame
  std::array<double, 6> covariance{};  ///< xx, yy, aa, xy, ya, xa; m2, rad2 and m rad
  double weight = 0.0;                 ///< of all particles, 0..1
};

/// A guess of where the robot is.
struct AmclParticle {
  Pose2 pose;           ///< m and rad, in the map's frame
  double weight = 0.0;  ///< all of them sum up to 1
};

/// Adaptive Monte Carlo localisation: where on a map a robot is, from odometry and a laser (D. Fox,
/// "Adapting the sample size in particle filters through KLD-sampling", IJRR 2003; S. Thrun, W.
/// Burgard and D. Fox, "Probabilistic Robotics", 2005; specs: player.md G.5). Deterministic: random
/// numbers are a function of (seed, update, particle). Not thread safe.
class Amcl {
 public:
  /// Starts with particles about init_pose. Throws Error when a setting is out of its range.
  Amcl(OccupancyGrid map, const AmclOptions& options);

  const OccupancyGrid& map() const { return map_; }

  /// Starts anew with particles about `mean`, normally distributed (Player's SET_POSE): standard
  /// deviations in m, m and rad. Throws Error when a number is not finite or a deviation negative.
  void SetPose(const Pose2& mean, const std::array<double, 3>& deviation);
  /// Starts anew with particles all over the map's free cells.
  void SetPoseUnknown();

  /// The robot's odometry (m and rad, in a frame of its own) and a scan taken there. Updates the
  /// particles the first time and after each move of update_thresh; true when it did.
  bool Step(const Pose2& odometry, const ScanView& scan);

  /// Clusters of particles, the heaviest first; there is always one.
  const std::vector<AmclHypothesis>& hypotheses() const { return hypotheses_; }
  /// Where the robot most likely is now: the first hypothesis, moved on by the odometry since.
  Pose2 BestPose() const;
  /// Player's GET_PARTICLES.
  const std::vector<AmclParticle>& particles() const { return particles_; }
  std::uint64_t updates() const { return update_; }

  /// How many particles KLD sampling asks for when `bins` bins have some, within the limits.
  int SampleLimit(int bins) const;

 private:
  enum class Purpose : std::uint32_t { kInit, kMove, kResample };
  std::array<std::uint32_t, 4> Random(Purpose purpose, std::uint32_t number,
                                      std::uint32_t part) const;
  void Move(const Pose2& from, const Pose2& to);
  void Weigh(const ScanView& scan);
  void Resample();
  void Cluster();

  const OccupancyGrid map_;
  const AmclOptions options_;
  std::vector<AmclParticle> particles_;
  std::vector<AmclHypothesis> hypotheses_;
  std::optional<Pose2> updated_at_;  // odometry
  Pose2 odometry_;                   // the latest
  std::uint64_t update_ = 0;
  std::uint64_t round_ = 0;  // of random numbers: updates and starts
};

}  // namespace ccmorse::navigation
