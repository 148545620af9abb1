#include "sim/sensors/laser_scanner.h"

#include <algorithm>
#include <array>
#include <utility>

#include "sim/rays/range_engine.h"
#include "sim/robots/robot.h"
#include "sim/world.h"

namespace ccmorse::sim {
namespace {

constexpr std::size_t kBytesPerBeam = 72;  // of text, about

// `direction(i)`: where beam i points to.
template <typename Direction>
void AppendScan(std::string& out, const std::vector<double>& ranges, double range,
                const Direction& direction) {
  out += ", \"point_list\": [";
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    out += i == 0 ? "[" : ", [";
    const bool hit = ranges[i] < range;
    const Vec3 point = hit ? ranges[i] * direction(i) : Vec3{};
    AppendJson(out, point.x);
    out += ", ";
    AppendJson(out, point.y);
    out += ", ";
    AppendJson(out, point.z);
    out += ']';
  }
  out += "], \"range_list\": [";
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (i > 0) out += ", ";
    AppendJson(out, ranges[i]);
  }
  out += ']';
}

}  // namespace

LaserScanner::LaserScanner(Robot& robot, const std::string& name, const scene::LaserDef& def,
                           const World& world, std::uint64_t seed)
    : LaserScanner(robot, name, "LaserScanner", def, world, seed) {}

LaserScanner::LaserScanner(Robot& robot, const std::string& name, const char* type,
                           const scene::LaserDef& def, const World& world, std::uint64_t seed)
    : Sensor(robot, name, type, def.frequency),
      def_(def),
      world_(world),
      fan_(def),
      noise_(seed, full_name()),
      ranges_(fan_.count(), def.range) {
  if (fan_.upright()) world_.PrepareCut(robot.model().origin_height + def.position.z);
  AddService({"mirror", {{"ranges"}}, [this](Arguments arguments) {
                Mirror(arguments);
                return Json();
              }});
}

void LaserScanner::Mounted() {
  if (is_carried()) LetMove();
}

void LaserScanner::LetMove() {
  moves_ = true;
  fan_.Untie();
  point_directions_.reset();
}

void LaserScanner::Mirror(Arguments arguments) {
  const std::string expected = "ranges must be a list of " + std::to_string(ranges_.size()) +
                               " numbers from 0 to " + std::to_string(def_.range);
  if (!arguments[0].IsArray()) throw WrongArgument(expected);
  const Json::Array& given = arguments[0].AsArray();
  std::vector<double> ranges;
  for (const Json& range : given) {
    if (!range.IsNumber()) throw WrongArgument(expected);
    ranges.push_back(range.AsDouble());
    if (!(ranges.back() >= 0.0 && ranges.back() <= def_.range)) throw WrongArgument(expected);
  }
  if (ranges.size() != ranges_.size()) throw WrongArgument(expected);
  mirrored_ = std::move(ranges);
}

void LaserScanner::Sample(const Instant& now) {
  if (!mirrored_.empty()) {
    ranges_ = mirrored_;
    return DataChanged(now.time);
  }
  if (moves_) fan_.Place(mount(), FanRotation());
  world_.rays().Scan(fan_, robot().pose(), robot().position().z, robot().index(), ranges_);
  if (def_.range_std > 0.0) AddNoise(now.tick);
  DataChanged(now.time);
}

void LaserScanner::AddNoise(std::uint64_t tick) {
  // Two at a time, as they are made, so that no scratch is needed.
  for (std::size_t i = 0; i < ranges_.size(); i += 2) {
    std::array<double, 2> off{};
    noise_.AddGaussian(tick, def_.range_std, off.data(), 2, static_cast<std::uint32_t>(i));
    for (std::size_t k = i; k < std::min(i + 2, ranges_.size()); ++k) {
      // A beam without a hit has no range to be wrong about.
      if (ranges_[k] < def_.range)
        ranges_[k] = std::clamp(ranges_[k] + off[k - i], 0.0, def_.range);
    }
  }
}

void LaserScanner::Prepare() {
  const double height = robot().model().origin_height + def_.position.z;
  if (world_.rays().Choose(fan_, height, robot().index()) == RayPath::kEmbree) {
    world_.rays().Prepare();
  }
}

void LaserScanner::Reset() {
  Sensor::Reset();
  std::fill(ranges_.begin(), ranges_.end(), def_.range);
  mirrored_.clear();
}

void LaserScanner::AddToHash(StateHash& hash) const { hash.Add(ranges_); }

Json LaserScanner::Configurations() const {
  return Json(Json::Object{{"laser_range", def_.range},
                           {"resolution", def_.resolution_deg},
                           {"scan_window", def_.scan_window_deg},
                           {"Visible_arc", def_.visible_arc},
                           {"layers", def_.layers},
                           {"layer_separation", def_.layer_separation},
                           {"layer_offset", def_.layer_offset},
                           {"frequency", def_.frequency}});
}

void LaserScanner::AppendNumbers(std::vector<double>& out) const {
  out.insert(out.end(), ranges_.begin(), ranges_.end());
}

void LaserScanner::AppendFields(std::string& out) const {
  AppendScan(out, ranges_, def_.range, [this](std::size_t i) { return PointDirection(i); });
}

std::function<std::string()> LaserScanner::TextLater() {
  if (point_directions_ == nullptr) {
    std::vector<Vec3> directions;
    directions.reserve(ranges_.size());
    for (std::size_t i = 0; i < ranges_.size(); ++i) directions.push_back(PointDirection(i));
    point_directions_ = std::make_shared<const std::vector<Vec3>>(std::move(directions));
  }
  return
      [time = timestamp(), range = def_.range, ranges = ranges_, directions = point_directions_] {
        std::string text;
        text.reserve(kBytesPerBeam * ranges.size());
        text += "{\"timestamp\": ";
        AppendJson(text, time);
        AppendScan(text, ranges, range, [&](std::size_t i) { return (*directions)[i]; });
        text += '}';
        return text;
      };
}

}  // namespace ccmorse::sim
