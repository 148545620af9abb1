#include "render/denoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <thread>

#include "render/vector_math.h"

namespace ccmorse::render {
namespace {

constexpr int kRounds = 5;
constexpr std::array<double, 3> kKernel = {3.0 / 8.0, 1.0 / 4.0, 1.0 / 16.0};  // B3 spline
constexpr double kLightEdge = 2.0;  // standard deviations of a difference that is an edge
constexpr double kNormalPower = 64.0;
constexpr double kDepthEdge = 0.02;  // share of the distance
constexpr double kLeastAlbedo = 0.04;

struct Field {
  std::vector<Vec3> light;  // over the albedo
  std::vector<double> variance;
};

class Filter {
 public:
  Filter(const Radiance& guide, int step) : guide_(guide), step_(step) {}

  void Rows(const Field& from, Field& to, int begin, int end) const {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < guide_.width; ++x) Pixel(from, to, x, y);
    }
  }

 private:
  std::size_t At(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(guide_.width) +
           static_cast<std::size_t>(x);
  }

  void Pixel(const Field& from, Field& to, int x, int y) const {
    const std::size_t here = At(x, y);
    to.light[here] = from.light[here];
    to.variance[here] = from.variance[here];
    if (guide_.distance[here] <= 0.0) return;
    const double own = Luminance(from.light[here]);
    const double edge = kLightEdge * std::sqrt(NearVariance(from, x, y)) + 1e-4;
    Vec3 sum;
    double weights = 0.0;
    double variance = 0.0;
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        const int px = x + dx * step_;
        const int py = y + dy * step_;
        if (px < 0 || py < 0 || px >= guide_.width || py >= guide_.height) continue;
        const std::size_t there = At(px, py);
        if (guide_.distance[there] <= 0.0) continue;
        const double aligned = std::max(0.0, Dot(guide_.normal[here], guide_.normal[there]));
        const double far = std::fabs(guide_.distance[here] - guide_.distance[there]) /
                           (kDepthEdge * guide_.distance[here] * step_);
        const double off = std::fabs(own - Luminance(from.light[there])) / edge;
        const double weight = kKernel[static_cast<std::size_t>(std::abs(dx))] *
                              kKernel[static_cast<std::size_t>(std::abs(dy))] *
                              std::pow(aligned, kNormalPower) * std::exp(-far - off);
        sum = sum + weight * from.light[there];
        variance += weight * weight * from.variance[there];
        weights += weight;
      }
    }
    if (weights <= 0.0) return;
    to.light[here] = (1.0 / weights) * sum;
    to.variance[here] = variance / (weights * weights);
  }

  // The variance around, as one pixel's own is a guess from few samples.
  double NearVariance(const Field& from, int x, int y) const {
    double sum = 0.0;
    double weights = 0.0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int px = std::clamp(x + dx, 0, guide_.width - 1);
        const int py = std::clamp(y + dy, 0, guide_.height - 1);
        const double weight = (dx == 0 ? 2.0 : 1.0) * (dy == 0 ? 2.0 : 1.0);
        sum += weight * from.variance[At(px, py)];
        weights += weight;
      }
    }
    return sum / weights;
  }

  const Radiance& guide_;
  int step_;
};

// Undoes OverAlbedo().
Vec3 TimesAlbedo(const Vec3& light, const Vec3& albedo) {
  return {light.x * std::max(albedo.x, kLeastAlbedo), light.y * std::max(albedo.y, kLeastAlbedo),
          light.z * std::max(albedo.z, kLeastAlbedo)};
}

}  // namespace

Vec3 OverAlbedo(const Vec3& light, const Vec3& albedo) {
  return {light.x / std::max(albedo.x, kLeastAlbedo), light.y / std::max(albedo.y, kLeastAlbedo),
          light.z / std::max(albedo.z, kLeastAlbedo)};
}

void Denoise(Radiance& radiance, int threads) {
  Field field{radiance.light, radiance.variance};
  for (std::size_t i = 0; i < field.light.size(); ++i) {
    field.light[i] = OverAlbedo(field.light[i], radiance.albedo[i]);
  }
  Field next = field;
  for (int round = 0; round < kRounds; ++round) {
    const Filter filter(radiance, 1 << round);
    std::vector<std::thread> workers;
    for (int part = 0; part < threads; ++part) {
      workers.emplace_back([&, part] {
        filter.Rows(field, next, radiance.height * part / threads,
                    radiance.height * (part + 1) / threads);
      });
    }
    for (std::thread& worker : workers) worker.join();
    std::swap(field, next);
  }
  for (std::size_t i = 0; i < field.light.size(); ++i) {
    radiance.light[i] = TimesAlbedo(field.light[i], radiance.albedo[i]);
  }
}

}  // namespace ccmorse::render
