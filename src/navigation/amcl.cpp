#include "navigation/amcl.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/philox.h"
#include "base/polygon.h"

namespace ccmorse::navigation {
namespace {

using Bin = std::array<int, 3>;

// Bins of the heading around the full circle; the last one may be narrower.
int TurnBins(const std::array<double, 3>& size) {
  return std::max(1, static_cast<int>(std::ceil(2.0 * kPi / size[2] - 1e-9)));
}

Bin BinOf(const Pose2& pose, const std::array<double, 3>& size) {
  const auto cell = [](double value, double step) {
    return static_cast<int>(std::floor(std::clamp(value / step, -1e9, 1e9)));
  };
  return {cell(pose.x, size[0]), cell(pose.y, size[1]),
          std::min(cell(NormalizeAngle(pose.yaw) + kPi, size[2]), TurnBins(size) - 1)};
}

// The pose `to` as seen from `from`.
Pose2 Relative(const Pose2& from, const Pose2& to) {
  const Vec2 moved = InverseTransform(from, {to.x, to.y});
  return {moved.x, moved.y, NormalizeAngle(to.yaw - from.yaw)};
}

Pose2 Compose(const Pose2& from, const Pose2& move) {
  const Vec2 there = Transform(from, {move.x, move.y});
  return {there.x, there.y, NormalizeAngle(from.yaw + move.yaw)};
}

AmclHypothesis Summary(const std::vector<AmclParticle>& particles,
                       const std::vector<std::size_t>& members) {
  AmclHypothesis summary;
  double x = 0.0;
  double y = 0.0;
  double sines = 0.0;
  double cosines = 0.0;
  for (const std::size_t i : members) {
    const AmclParticle& particle = particles[i];
    const auto [sine, cosine] = SinCos(particle.pose.yaw);
    summary.weight += particle.weight;
    x += particle.weight * particle.pose.x;
    y += particle.weight * particle.pose.y;
    sines += particle.weight * sine;
    cosines += particle.weight * cosine;
  }
  if (!(summary.weight > 0.0)) return summary;
  summary.mean = {x / summary.weight, y / summary.weight, Atan2(sines, cosines)};
  for (const std::size_t i : members) {
    const AmclParticle& particle = particles[i];
    const double share = particle.weight / summary.weight;
    const double dx = particle.pose.x - summary.mean.x;
    const double dy = particle.pose.y - summary.mean.y;
    const double da = NormalizeAngle(particle.pose.yaw - summary.mean.yaw);
    const std::array<double, 6> products = {dx * dx, dy * dy, da * da, dx * dy, dy * da, dx * da};
    for (std::size_t k = 0; k < products.size(); ++k) {
      summary.covariance[k] += share * products[k];
    }
  }
  return summary;
}

}  // namespace

AmclOptions AmclOptionsForS1r() {
  AmclOptions options;
  options.kld_bin = {0.2, 0.2, Radians(10.0)};
  options.pf_err = 0.03;
  options.pf_min_samples = 200;
  options.init_pose = {1.71, 1.86, 0.0};
  options.update_thresh = {0.05, kPi / 12.0};
  options.odom_drift = {{{0.1, 0.0, 0.05}, {0.0, 0.1, 0.05}, {0.2, 0.0, 0.15}}};
  options.laser_max_beams = 30;
  options.laser_range_max = 5.0;
  options.laser_range_var = 0.06;
  options.laser_range_bad = 0.2;
  return options;
}

Amcl::Amcl(OccupancyGrid map, const AmclOptions& options)
    : map_(std::move(map)), options_(options) {
  const auto check = [](bool right, const char* what) {
    if (!right) throw Error(std::string("amcl: ") + what);
  };
  check(options.pf_min_samples > 0 && options.pf_max_samples >= options.pf_min_samples &&
            options.pf_max_samples <= 10000000,
        "pf_min_samples and pf_max_samples must be positive and in order");
  check(options.pf_err > 0.0 && options.pf_z > 0.0, "pf_err and pf_z must be positive");
  for (const double size : options.kld_bin) check(size > 0.0, "kld_bin must be positive");
  for (const double step : options.update_thresh) {
    check(step >= 0.0, "update_thresh must not be negative");
  }
  for (const auto& row : options.odom_drift) {
    for (const double drift : row) check(drift >= 0.0, "odom_drift must not be negative");
  }
  check(options.laser_max_beams >= 2, "laser_max_beams must be at least 2");
  check(options.laser_range_max > 0.0, "laser_range_max must be positive");
  check(options.laser_range_var > 0.0, "laser_range_var must be positive");
  check(options.laser_range_bad > 0.0 && options.laser_range_bad < 1.0,
        "laser_range_bad must be between 0 and 1");
  SetPose(options.init_pose, options.init_pose_var);
}

std::array<std::uint32_t, 4> Amcl::Random(Purpose purpose, std::uint32_t number,
                                          std::uint32_t part) const {
  return Philox(
      {number, static_cast<std::uint32_t>(round_), static_cast<std::uint32_t>(round_ >> 32),
       static_cast<std::uint32_t>(purpose) << 8 | part},
      {static_cast<std::uint32_t>(options_.seed), static_cast<std::uint32_t>(options_.seed >> 32)});
}

void Amcl::SetPose(const Pose2& mean, const std::array<double, 3>& deviation) {
  for (const double value : {mean.x, mean.y, mean.yaw, deviation[0], deviation[1], deviation[2]}) {
    if (!std::isfinite(value)) throw Error("amcl: a number of the pose is not finite");
  }
  for (const double value : deviation) {
    if (value < 0.0) throw Error("amcl: a deviation of the pose is negative");
  }
  ++round_;
  particles_.resize(static_cast<std::size_t>(options_.pf_max_samples));
  const double weight = 1.0 / static_cast<double>(particles_.size());
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const auto [x, y] = GaussianPair(Random(Purpose::kInit, number, 0));
    const double turn = GaussianPair(Random(Purpose::kInit, number, 1))[0];
    particles_[i] = {{mean.x + deviation[0] * x, mean.y + deviation[1] * y,
                      NormalizeAngle(mean.yaw + deviation[2] * turn)},
                     weight};
  }
  updated_at_.reset();
  Cluster();
}

void Amcl::SetPoseUnknown() {
  std::vector<CellIndex> free;
  for (int y = 0; y < map_.height(); ++y) {
    for (int x = 0; x < map_.width(); ++x) {
      if (map_.At({x, y}) == Cell::kFree) free.push_back({x, y});
    }
  }
  if (free.empty()) throw Error("amcl: the map has no free cell");
  ++round_;
  particles_.resize(static_cast<std::size_t>(options_.pf_max_samples));
  const double weight = 1.0 / static_cast<double>(particles_.size());
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const auto where = Random(Purpose::kInit, number, 2);
    const auto how = Random(Purpose::kInit, number, 3);
    const double pick = OpenUniform(where[0], where[1]) * static_cast<double>(free.size());
    const Vec2 centre =
        map_.CentreOf(free[std::min(free.size() - 1, static_cast<std::size_t>(pick))]);
    particles_[i] = {{centre.x + map_.scale() * (OpenUniform(where[2], where[3]) - 0.5),
                      centre.y + map_.scale() * (OpenUniform(how[0], how[1]) - 0.5),
                      kPi * (2.0 * OpenUniform(how[2], how[3]) - 1.0)},
                     weight};
  }
  updated_at_.reset();
  Cluster();
}

int Amcl::SampleLimit(int bins) const {
  if (bins <= 1) return options_.pf_min_samples;
  // Wilson and Hilferty's approximation of the chi-square quantile, as in Fox's paper.
  const double a = 2.0 / (9.0 * (bins - 1));
  const double b = 1.0 - a + std::sqrt(a) * options_.pf_z;
  const double count = std::ceil((bins - 1) / (2.0 * options_.pf_err) * b * b * b);
  return static_cast<int>(std::clamp(count, static_cast<double>(options_.pf_min_samples),
                                     static_cast<double>(options_.pf_max_samples)));
}

void Amcl::Move(const Pose2& from, const Pose2& to) {
  const Pose2 move = Relative(from, to);
  const std::array<double, 3> amount = {std::abs(move.x), std::abs(move.y), std::abs(move.yaw)};
  std::array<double, 3> deviation{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t k = 0; k < 3; ++k) deviation[row] += options_.odom_drift[row][k] * amount[k];
  }
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const auto [x, y] = GaussianPair(Random(Purpose::kMove, number, 0));
    const double turn = GaussianPair(Random(Purpose::kMove, number, 1))[0];
    particles_[i].pose =
        Compose(particles_[i].pose, {move.x + deviation[0] * x, move.y + deviation[1] * y,
                                     NormalizeAngle(move.yaw + deviation[2] * turn)});
  }
}

void Amcl::Weigh(const ScanView& scan) {
  const std::size_t count = scan.ranges.size();
  if (count == 0) return;
  const auto beams = std::min(static_cast<std::size_t>(options_.laser_max_beams), count);
  struct Beam {
    double bearing;
    double range;
  };
  std::vector<Beam> used;
  for (std::size_t k = 0; k < beams; ++k) {
    const std::size_t i = beams > 1 ? k * (count - 1) / (beams - 1) : 0;
    double range = CleanRange(scan.ranges[i], scan.range_max);
    range = range >= scan.range_max ? options_.laser_range_max
                                    : std::min(range, options_.laser_range_max);
    used.push_back({scan.min_angle + static_cast<double>(i) * scan.resolution, range});
  }
  // A scanner of a shorter range sees nothing beyond it, whatever the map says.
  const double reach = std::min(scan.range_max, options_.laser_range_max);
  const double narrow = -0.5 / (options_.laser_range_var * options_.laser_range_var);
  double sum = 0.0;
  for (AmclParticle& particle : particles_) {
    const Pose2 scanner = Compose(particle.pose, scan.mount);
    for (const Beam& beam : used) {
      const double expected =
          map_.CastRay({scanner.x, scanner.y}, scanner.yaw + beam.bearing, reach);
      const double error = std::min(beam.range, reach) - expected;
      particle.weight *=
          options_.laser_range_bad + (1.0 - options_.laser_range_bad) * Exp(narrow * error * error);
    }
    // Nobody stands in a wall.
    if (map_.At(map_.CellOf({particle.pose.x, particle.pose.y})) == Cell::kOccupied) {
      particle.weight *= 1e-6;
    }
    sum += particle.weight;
  }
  const double even = 1.0 / static_cast<double>(particles_.size());
  for (AmclParticle& particle : particles_) {
    particle.weight = sum > 0.0 ? particle.weight / sum : even;
  }
}

void Amcl::Resample() {
  std::vector<double> up_to;
  up_to.reserve(particles_.size());
  double sum = 0.0;
  for (const AmclParticle& particle : particles_) {
    sum += particle.weight;
    up_to.push_back(sum);
  }
  std::vector<AmclParticle> drawn;
  std::set<Bin> bins;
  int wanted = options_.pf_max_samples;
  while (static_cast<int>(drawn.size()) < wanted) {
    const auto bits = Random(Purpose::kResample, static_cast<std::uint32_t>(drawn.size()), 0);
    const double pick = OpenUniform(bits[0], bits[1]) * sum;
    const auto place = std::upper_bound(up_to.begin(), up_to.end(), pick) - up_to.begin();
    const auto index = std::min(particles_.size() - 1, static_cast<std::size_t>(place));
    drawn.push_back(particles_[index]);
    if (bins.insert(BinOf(drawn.back().pose, options_.kld_bin)).second) {
      wanted = SampleLimit(static_cast<int>(bins.size()));
    }
  }
  const double weight = 1.0 / static_cast<double>(drawn.size());
  for (AmclParticle& particle : drawn) particle.weight = weight;
  particles_ = std::move(drawn);
}

void Amcl::Cluster() {
  // Bins that touch, also over the end of the circle, make a cluster.
  std::map<Bin, std::vector<std::size_t>> bins;
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    bins[BinOf(particles_[i].pose, options_.kld_bin)].push_back(i);
  }
  const int turn_bins = TurnBins(options_.kld_bin);
  std::set<Bin> seen;
  hypotheses_.clear();
  for (const auto& entry : bins) {
    if (!seen.insert(entry.first).second) continue;
    std::vector<Bin> open = {entry.first};
    std::vector<std::size_t> members;
    while (!open.empty()) {
      const Bin bin = open.back();
      open.pop_back();
      const auto& inside = bins[bin];
      members.insert(members.end(), inside.begin(), inside.end());
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) {
          for (int da = -1; da <= 1; ++da) {
            const Bin next = {bin[0] + dx, bin[1] + dy, (bin[2] + da + turn_bins) % turn_bins};
            if (bins.count(next) != 0 && seen.insert(next).second) open.push_back(next);
          }
        }
      }
    }
    // In one order, whichever bin the cluster was found by.
    std::sort(members.begin(), members.end());
    hypotheses_.push_back(Summary(particles_, members));
  }
  std::stable_sort(
      hypotheses_.begin(), hypotheses_.end(),
      [](const AmclHypothesis& a, const AmclHypothesis& b) { return a.weight > b.weight; });
}

bool Amcl::Step(const Pose2& odometry, const ScanView& scan) {
  odometry_ = odometry;
  if (updated_at_) {
    const Pose2 move = Relative(*updated_at_, odometry);
    const double distance = std::sqrt(move.x * move.x + move.y * move.y);
    if (distance < options_.update_thresh[0] && std::abs(move.yaw) < options_.update_thresh[1]) {
      return false;
    }
  }
  ++round_;
  ++update_;
  if (updated_at_ && options_.odom_init) Move(*updated_at_, odometry);
  updated_at_ = odometry;
  Weigh(scan);
  Resample();
  Cluster();
  return true;
}

Pose2 Amcl::BestPose() const {
  const Pose2& mean = hypotheses_.front().mean;
  if (!updated_at_ || !options_.odom_init) return mean;
  return Compose(mean, Relative(*updated_at_, odometry_));
}

}  // namespace ccmorse::navigation
