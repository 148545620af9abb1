#include "render/path_tracer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/philox.h"
#include "base/trig.h"
#include "render/denoise.h"
#include "render/vector_math.h"

namespace ccmorse::render {
namespace {

constexpr int kTile = 16;           // pixels a side: as many paths run together
constexpr double kFar = 1e5;        // m
constexpr double kOff = 1e-5;       // m: paths go on from so far off the surface
constexpr double kBrightest = 6.0;  // of light over several surfaces: rare flashes are cut to it

// Decisions of a path, each with samples of its own: kOfPixel once, the others for each surface.
enum Decision : std::uint32_t { kOfPixel, kOfSun, kOfSpot, kWhichSpot, kWhichLobe, kDirection };
constexpr std::uint32_t kDecisions = 8;

Vec3 Times(const Vec3& a, const Vec3& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
// Two axes that make a right-handed frame with the unit vector z (T. Duff et al., "Building an
// orthonormal basis, revisited", JCGT 2017).
void Frame(const Vec3& z, Vec3& x, Vec3& y) {
  const double sign = std::copysign(1.0, z.z);
  const double a = -1.0 / (sign + z.z);
  const double b = z.x * z.y * a;
  x = {1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x};
  y = {b, sign + z.y * z.y * a, -z.y};
}

Vec3 InFrame(const Vec3& z, double x_part, double y_part, double z_part) {
  Vec3 x;
  Vec3 y;
  Frame(z, x, y);
  return x_part * x + y_part * y + z_part * z;
}

// Points in the unit square that fill it evenly for the samples of each pixel and decision: the R2
// sequence (M. Roberts, 2018), shifted and taken in another order for each.
class Sampler {
 public:
  Sampler(std::uint32_t seed, int samples) : seed_(seed) {
    while (mask_ + 1 < static_cast<std::uint32_t>(samples)) mask_ = 2 * mask_ + 1;
  }

  Vec2 operator()(std::uint32_t pixel, std::uint32_t sample, std::uint32_t decision) const {
    const auto bits = Philox({pixel, decision, 0, 0}, {seed_, 0});
    const auto i = static_cast<double>(sample ^ (bits[2] & mask_));
    constexpr double kPlastic = 1.32471795724474602596;
    const double u = bits[0] * 0x1p-32 + i / kPlastic;
    const double v = bits[1] * 0x1p-32 + i / (kPlastic * kPlastic);
    return {u - std::floor(u), v - std::floor(v)};
  }

 private:
  std::uint32_t seed_;
  std::uint32_t mask_ = 0;
};

Vec3 InDisk(Vec2 sample, double radius) {
  const auto [s, c] = SinCos(2.0 * kPi * sample.x);
  const double r = radius * std::sqrt(sample.y);
  return {r * c, r * s, 0.0};
}

// Schlick's approximation; no coat reflects nothing.
double Fresnel(double at_normal, double cosine) {
  if (at_normal <= 0.0) return 0.0;
  const double x = std::clamp(1.0 - cosine, 0.0, 1.0);
  return at_normal + (1.0 - at_normal) * x * x * x * x * x;
}

// The share of microfacets that face `cosine` off the normal, a unit of solid angle (GGX).
double Facets(double roughness, double cosine) {
  const double a = roughness * roughness;
  const double d = cosine * cosine * (a * a - 1.0) + 1.0;
  return a * a / (kPi * d * d);
}

struct Path {
  sim::Ray ray;
  Vec3 weight{1, 1, 1};
  Vec3 light;
  std::uint32_t pixel = 0;
  std::size_t slot = 0;  // in the tile
};

// A question whether a lamp is seen, and what it adds if so.
struct Shadow {
  sim::Ray ray;
  double distance = kFar;
  Vec3 light;
  std::size_t slot = 0;
};

class Tracer {
 public:
  Tracer(const PictureScene& scene, const Camera& camera, const RenderOptions& options,
         Radiance& out)
      : scene_(scene),
        camera_(camera),
        options_(options),
        out_(out),
        sampler_(options.seed, options.samples) {}

  void Tile(int left, int top) {
    const int right = std::min(left + kTile, options_.width);
    const int bottom = std::min(top + kTile, options_.height);
    const auto count =
        static_cast<std::size_t>(right - left) * static_cast<std::size_t>(bottom - top);
    sums_.assign(count, {});
    for (int sample = 0; sample < options_.samples; ++sample) {
      sample_ = static_cast<std::uint32_t>(sample);
      lights_.assign(count, {});
      paths_.clear();
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) Start(x, y);
      }
      for (int bounce = 0; bounce < options_.bounces && !paths_.empty(); ++bounce) Go(bounce);
      for (std::size_t slot = 0; slot < count; ++slot) Gather(slot);
    }
    std::size_t slot = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) Finish(slot++, x, y);
    }
  }

 private:
  // Sums over the samples of a pixel.
  struct Sums {
    Vec3 light, albedo, normal, film;
    double distance = 0.0, through = 0.0, luminance = 0.0, squares = 0.0;
    int seen = 0;
  };

  void Start(int x, int y) {
    const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(options_.width) +
                       static_cast<std::uint32_t>(x);
    const Vec2 at = sampler_(pixel, sample_, kOfPixel);
    const double half = options_.height / 2.0;
    Path path;
    path.ray = {camera_.position, camera_.Direction((x + at.x - options_.width / 2.0) / half,
                                                    -(y + at.y - half) / half)};
    path.pixel = pixel;
    path.slot = paths_.size();
    firsts_.resize(std::max(firsts_.size(), path.slot + 1));
    firsts_[path.slot] = {path.ray, kFar, {1, 1, 1}, {}};
    paths_.push_back(path);
  }

  // All paths of the tile one surface further.
  void Go(int bounce) {
    rays_.clear();
    for (const Path& path : paths_) rays_.push_back(path.ray);
    hits_.resize(rays_.size());
    scene_.Trace(rays_, kFar, hits_);
    shadows_.clear();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      Path path = paths_[i];
      if (Meet(path, hits_[i], bounce)) paths_[kept++] = path;
    }
    paths_.resize(kept);
    // Which of the lamps are seen?
    rays_.clear();
    for (const Shadow& shadow : shadows_) rays_.push_back(shadow.ray);
    hits_.resize(rays_.size());
    scene_.Trace(rays_, kFar, hits_);
    for (std::size_t i = 0; i < shadows_.size(); ++i) {
      if (hits_[i].distance >= shadows_[i].distance)
        Add(shadows_[i].slot, shadows_[i].light, bounce);
    }
  }

  void Add(std::size_t slot, Vec3 light, int bounce) {
    if (bounce > 0) {
      const double most = std::max({light.x, light.y, light.z});
      if (most > kBrightest) light = (kBrightest / most) * light;
    }
    lights_[slot] = lights_[slot] + light;
  }

  Vec3 Sky(const Vec3& direction) const {
    const double up = std::max(0.0, direction.z);
    return scene_.sky *
           ((1.0 - 0.25 * up) * Vec3{1.0, 1.0, 1.0} + (0.25 * up) * Vec3{0.8, 0.95, 1.25});
  }

  // The path at its next surface: asks for the lamps and turns; false when it ends here.
  bool Meet(Path& path, const sim::RayHit& hit, int bounce) {
    if (hit.surface.kind == sim::HitKind::kNothing) {
      Add(path.slot, Times(path.weight, bounce == 0 ? scene_.background : Sky(path.ray.direction)),
          bounce);
      return false;
    }
    const Vec3 point = path.ray.origin + hit.distance * path.ray.direction;
    const Vec3 view = -1.0 * path.ray.direction;
    Vec3 flat = scene_.FlatNormal(hit);
    if (Dot(flat, view) < 0.0) flat = -1.0 * flat;
    Vec3 normal = scene_.Normal(hit, point);
    if (Dot(normal, flat) < 0.0) normal = -1.0 * normal;
    if (Dot(normal, view) < 0.01) normal = flat;
    const int index = scene_.MaterialOf(hit);
    const Material& material = scene_.material(index);
    Vec3 color = material.color;
    if (index == scene_.floor_material && scene_.floor_color) {
      color = scene_.floor_color(point.x, point.y);
    }
    if (bounce == 0) {
      firsts_[path.slot] = {path.ray, hit.distance, material.metal ? Vec3{1, 1, 1} : color, normal};
      if (index == scene_.ground_material) {
        const double far = std::hypot(point.x - scene_.middle.x, point.y - scene_.middle.y);
        const double faded = std::clamp(far / scene_.fade_from - 1.0, 0.0, 1.0);
        const double share = faded * faded * (3.0 - 2.0 * faded);
        Add(path.slot, share * scene_.background, bounce);
        path.weight = (1.0 - share) * path.weight;
        if (share >= 1.0) {
          firsts_[path.slot].distance = kFar;
          return false;
        }
      }
    }
    const double facing = std::max(1e-4, Dot(normal, view));
    const std::uint32_t first = kDecisions * (static_cast<std::uint32_t>(bounce) + 1);
    const auto decide = [&](std::uint32_t decision) {
      return sampler_(path.pixel, sample_, first + decision);
    };
    const Vec3 start = point + kOff * flat;
    const Surfel surfel{view, normal, flat, color, facing, &material};
    for (const SunLight& sun : scene_.suns) {
      const Vec3 spot = InDisk(decide(kOfSun), sun.radius);
      const Vec3 to = Unit(InFrame(sun.direction, spot.x, spot.y, 1.0));
      Ask(path, surfel, start, to, kFar, sun.irradiance);
    }
    if (!scene_.spots.empty()) {
      const auto number = static_cast<double>(scene_.spots.size());
      const auto which = static_cast<std::size_t>(decide(kWhichSpot).x * number);
      const SpotLight& lamp = scene_.spots[std::min(which, scene_.spots.size() - 1)];
      const Vec3 on = lamp.position + InDisk(decide(kOfSpot), lamp.radius);
      const Vec3 way = on - start;
      const double distance = std::sqrt(Dot(way, way));
      const Vec3 to = (1.0 / distance) * way;
      // It shines down, less to the sides.
      const double down = std::max(0.0, to.z);
      Ask(path, surfel, start, to, distance,
          number * lamp.intensity * down * down / (distance * distance));
    }
    return Turn(path, surfel, start, decide(kWhichLobe).x, decide(kDirection));
  }

  // What a path has met.
  struct Surfel {
    Vec3 view, normal, flat, color;
    double facing;  // cosine between view and normal
    const Material* material;
  };

  // Light of irradiance `irradiance` from direction `to`, unless something is in its way.
  void Ask(const Path& path, const Surfel& at, const Vec3& start, const Vec3& to, double distance,
           double irradiance) {
    const double lit = Dot(at.normal, to);
    if (lit <= 0.0 || Dot(at.flat, to) <= 0.0 || irradiance <= 0.0) return;
    const Material& material = *at.material;
    const Vec3 half = Unit(at.view + to);
    const double toward = std::max(0.05, Dot(half, to));
    const double fresnel = material.metal ? 1.0 : Fresnel(material.coat, toward);
    // Kelemen's approximation of shadowing and masking.
    const double gloss =
        fresnel * Facets(material.roughness, Dot(at.normal, half)) / (4.0 * toward * toward);
    const Vec3 tint = material.metal ? at.color : Vec3{1, 1, 1};
    Vec3 light = kPi * gloss * tint;  // an irradiance of 1 makes white white: it is pi times that
    if (!material.metal) light = light + (1.0 - Fresnel(material.coat, at.facing)) * at.color;
    shadows_.push_back(
        {{start, to}, distance, lit * irradiance * Times(path.weight, light), path.slot});
  }

  bool Turn(Path& path, const Surfel& at, const Vec3& start, double which, Vec2 sample) const {
    const Material& material = *at.material;
    const double fresnel = material.metal ? 1.0 : Fresnel(material.coat, at.facing);
    // Coats that reflect little are looked at more often than they matter, and weighed less.
    const double share = material.metal ? 1.0 : std::clamp(fresnel, 0.1, 0.9);
    Vec3 direction;
    if (material.metal || (material.coat > 0.0 && which < share)) {
      const double a = material.roughness * material.roughness;
      const double cosine = std::sqrt((1.0 - sample.y) / (1.0 + (a * a - 1.0) * sample.y));
      const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
      const auto [s, c] = SinCos(2.0 * kPi * sample.x);
      const Vec3 half = InFrame(at.normal, sine * c, sine * s, cosine);
      direction = 2.0 * Dot(at.view, half) * half - at.view;
      const Vec3 tint = material.metal ? at.color : Vec3{1, 1, 1};
      path.weight = (fresnel / share) * Times(path.weight, tint);
    } else {
      const Vec3 disk = InDisk(sample, 1.0);
      const double up = std::sqrt(std::max(0.0, 1.0 - disk.x * disk.x - disk.y * disk.y));
      direction = InFrame(at.normal, disk.x, disk.y, up);
      const double chance = material.coat > 0.0 ? 1.0 - share : 1.0;
      path.weight = ((1.0 - fresnel) / chance) * Times(path.weight, at.color);
    }
    if (Dot(direction, at.flat) <= 0.0) return false;
    path.ray = {start, Unit(direction)};
    return Luminance(path.weight) > 1e-3;
  }

  void Gather(std::size_t slot) {
    Sums& sums = sums_[slot];
    const First& first = firsts_[slot];
    const Vec3& light = lights_[slot];
    sums.light = sums.light + light;
    sums.albedo = sums.albedo + first.albedo;
    if (first.distance < kFar) {
      sums.normal = sums.normal + first.normal;
      sums.distance += first.distance;
      ++sums.seen;
    }
    const double luminance = Luminance(OverAlbedo(light, first.albedo));
    sums.luminance += luminance;
    sums.squares += luminance * luminance;
    double through = 1.0;
    Vec3 film;
    for (const Fan& fan : scene_.fans) {
      const double share = ShareOf(fan, first);
      film = film + through * share * fan.color;
      through *= 1.0 - share;
    }
    sums.film = sums.film + film;
    sums.through += through;
  }

  struct First;
  // How much of the fan's colour the ray takes on before it meets its first surface.
  static double ShareOf(const Fan& fan, const First& first) {
    const sim::Ray& ray = first.ray;
    if (fan.ranges.size() < 2 || ray.direction.z == 0.0) return 0.0;
    const double along = (fan.origin.z - ray.origin.z) / ray.direction.z;
    if (along <= 0.0 || along >= first.distance) return 0.0;
    const double x = ray.origin.x + along * ray.direction.x - fan.origin.x;
    const double y = ray.origin.y + along * ray.direction.y - fan.origin.y;
    const double bearing = std::remainder(std::atan2(y, x) - fan.yaw, 2.0 * kPi);
    const double beam = (bearing - fan.first) / fan.step;
    if (beam < 0.0 || beam > static_cast<double>(fan.ranges.size() - 1)) return 0.0;
    const auto low = std::min(static_cast<std::size_t>(beam), fan.ranges.size() - 2);
    const double part = beam - static_cast<double>(low);
    const double range = (1.0 - part) * fan.ranges[low] + part * fan.ranges[low + 1];
    return x * x + y * y < range * range ? fan.opacity : 0.0;
  }

  void Finish(std::size_t slot, int x, int y) {
    const Sums& sums = sums_[slot];
    const double n = options_.samples;
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(options_.width) +
                    static_cast<std::size_t>(x);
    out_.light[at] = (1.0 / n) * sums.light;
    out_.albedo[at] = (1.0 / n) * sums.albedo;
    const double length = std::sqrt(Dot(sums.normal, sums.normal));
    out_.normal[at] = length > 0.0 ? (1.0 / length) * sums.normal : Vec3{};
    out_.distance[at] = sums.seen > 0 ? sums.distance / sums.seen : 0.0;
    const double mean = sums.luminance / n;
    out_.variance[at] = std::max(0.0, sums.squares / n - mean * mean) / n;
    out_.film[at] = (1.0 / n) * sums.film;
    out_.film_through[at] = sums.through / n;
  }

  const PictureScene& scene_;
  const Camera& camera_;
  const RenderOptions& options_;
  Radiance& out_;
  Sampler sampler_;
  std::uint32_t sample_ = 0;
  struct First {
    sim::Ray ray;
    double distance = 0.0;
    Vec3 albedo, normal;
  };
  std::vector<Path> paths_;
  std::vector<Shadow> shadows_;
  std::vector<First> firsts_;  // by slot
  std::vector<Vec3> lights_;   // by slot, of this sample
  std::vector<Sums> sums_;     // by slot
  std::vector<sim::Ray> rays_;
  std::vector<sim::RayHit> hits_;
};

void Check(const RenderOptions& options) {
  const auto within = [](const char* name, int value, int least, int most) {
    if (value < least || value > most) {
      throw Error("a picture's " + std::string(name) + " is " + std::to_string(least) + " to " +
                  std::to_string(most) + ", not " + std::to_string(value));
    }
  };
  within("width", options.width, 1, 8192);
  within("height", options.height, 1, 8192);
  within("samples", options.samples, 1, 65536);
  within("bounces", options.bounces, 1, 64);
}

int Threads(const RenderOptions& options) {
  if (options.threads > 0) return options.threads;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

// Light of 1 is white; brighter is bent towards it (K. Narkowicz's fit of the ACES filmic curve),
// then sRGB.
std::uint8_t Tone(double light) {
  const double x = std::max(0.0, 0.8 * light);
  const double bent =
      std::clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
  const double v = bent <= 0.0031308 ? 12.92 * bent : 1.055 * std::pow(bent, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * v));
}

}  // namespace

Radiance TracePaths(const PictureScene& scene, const Camera& camera, const RenderOptions& options) {
  Check(options);
  Radiance out;
  out.width = options.width;
  out.height = options.height;
  const auto size =
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  for (auto* field : {&out.light, &out.albedo, &out.normal, &out.film}) field->resize(size);
  for (auto* field : {&out.distance, &out.variance, &out.film_through}) field->resize(size);
  const int across = (options.width + kTile - 1) / kTile;
  const int tiles = across * ((options.height + kTile - 1) / kTile);
  std::atomic<int> next = 0;
  std::mutex reporting;
  int done = 0;
  const auto work = [&] {
    Tracer tracer(scene, camera, options, out);
    for (int tile = next++; tile < tiles; tile = next++) {
      tracer.Tile(kTile * (tile % across), kTile * (tile / across));
      if (!options.progress) continue;
      const std::lock_guard lock(reporting);
      options.progress(static_cast<double>(++done) / tiles);
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < Threads(options); ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  return out;
}

Image RenderPicture(const PictureScene& scene, const Camera& camera, const RenderOptions& options) {
  Radiance radiance = TracePaths(scene, camera, options);
  if (options.denoise) Denoise(radiance, Threads(options));
  Image image{radiance.width, radiance.height, {}};
  image.pixels.reserve(radiance.light.size());
  for (std::size_t i = 0; i < radiance.light.size(); ++i) {
    const Vec3 light = radiance.film_through[i] * radiance.light[i] + radiance.film[i];
    image.pixels.push_back({Tone(light.x), Tone(light.y), Tone(light.z)});
  }
  return image;
}

}  // namespace ccmorse::render
