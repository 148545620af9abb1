#include "servers/player/drivers/localization.h"

#include "base/error.h"
#include "base/image.h"
#include "servers/player/devices/map_device.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

// A pixel's brightness, 0..255, from which on it is light, and up to which it is dark; what is
// between is unknown.
constexpr int kLight = 230;
constexpr int kDark = 80;

GridMap ReadMap(const DriverOptions& options) {
  const std::string file = options.Text("filename", "");
  if (file.empty()) throw Error("driver mapfile: filename is missing");
  const Image image = ReadPng(file);
  GridMap map;
  map.scale = options.Length("resolution", 0.0);
  if (!(map.scale > 0.0)) throw Error("driver mapfile: resolution must be more than 0");
  map.width = image.width;
  map.height = image.height;
  map.origin = {-0.5 * image.width * map.scale, -0.5 * image.height * map.scale, 0.0};
  if (const Json* const origin = options.Find("origin")) {
    if (!origin->IsArray() || origin->AsArray().size() < 2 || !origin->AsArray()[0].IsNumber() ||
        !origin->AsArray()[1].IsNumber()) {
      throw Error("driver mapfile: origin must be [x y]");
    }
    map.origin.px = origin->AsArray()[0].AsDouble() * options.length_unit;
    map.origin.py = origin->AsArray()[1].AsDouble() * options.length_unit;
  }
  const bool negate = options.Number("negate", 0.0) != 0.0;
  map.cells.reserve(image.pixels.size());
  for (int y = image.height - 1; y >= 0; --y) {  // the picture's top row is the map's last
    for (int x = 0; x < image.width; ++x) {
      const Color pixel =
          image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x)];
      int brightness = (int{pixel.r} + pixel.g + pixel.b) / 3;
      if (negate) brightness = 255 - brightness;
      map.cells.push_back(brightness >= kLight  ? std::int8_t{-1}
                          : brightness <= kDark ? std::int8_t{1}
                                                : std::int8_t{0});
    }
  }
  return map;
}

}  // namespace

MapFile::MapFile(const DriverDef& def, const DeviceContext& context, const DeviceList& devices)
    : Driver(def, devices) {
  const Provided* const provided =
      Provide(wire::kMap, {{MessageType::kRequest, wire::kMapReqGetInfo},
                           {MessageType::kRequest, wire::kMapReqGetData}});
  if (provided == nullptr) throw Error("driver mapfile provides a map");
  map_ = std::make_shared<MapDevice>(context, provided->index(), ReadMap(def.options));
}

FakeLocalize::FakeLocalize(const DriverDef& def, const DeviceContext& context,
                           const DeviceList& devices)
    : Driver(def, devices),
      context_(context),
      simulation_(Require(wire::kSimulation)),
      model_(def.options.Text("model", def.robot)),
      rate_(context.simulation.scenario().time.read_frequency) {
  localize_ = Provide(wire::kLocalize, {{MessageType::kData, wire::kLocalizeDataHypoths},
                                        {MessageType::kRequest, wire::kLocalizeReqSetPose},
                                        {MessageType::kRequest, wire::kLocalizeReqGetParticles}});
  position_ = Provide(wire::kPosition2d, {{MessageType::kData, wire::kPosition2dDataState},
                                          {MessageType::kRequest, wire::kPosition2dReqGetGeom}});
  if (localize_ == nullptr && position_ == nullptr) {
    throw Error("driver fakelocalize provides a localize or a position2d");
  }
  wire::Pose2d pose;
  if (!ReadPose(pose)) throw Error("driver fakelocalize: there is no model '" + model_ + "'");
}

bool FakeLocalize::ReadPose(wire::Pose2d& pose) {
  wire::SimulationPose2dReq asked;
  asked.name = model_;
  Reply reply;
  if (!simulation_.Request(wire::kSimulationReqGetPose2d, wire::Body::Of(asked), reply) ||
      !reply.body().To(asked)) {
    return false;
  }
  pose = asked.pose;
  return true;
}

void FakeLocalize::Step() {
  wire::Pose2d pose;
  if (!rate_.TakeDue(context_.simulation) || !ReadPose(pose)) return;
  const double now = context_.simulation.time();
  if (localize_ != nullptr) {
    wire::LocalizeData data;
    data.pending_time = now;
    wire::LocalizeHypoth& only = data.hypoths.emplace_back();
    only.mean = pose;
    only.alpha = 1.0;
    localize_->Publish(wire::kLocalizeDataHypoths, now, wire::Body::Of(data));
  }
  if (position_ != nullptr) {
    wire::Position2dData data;
    data.pos = pose;
    position_->Publish(wire::kPosition2dDataState, now, wire::Body::Of(data));
  }
}

bool FakeLocalize::Ask(Provided& device, std::uint8_t subtype, const wire::Body& body,
                       Reply& reply) {
  if (&device == position_) {
    reply.Set(wire::Position2dGeom{});
    return body.empty();
  }
  if (subtype == wire::kLocalizeReqSetPose) {
    wire::LocalizeSetPose wanted;  // it knows better
    return body.To(wanted);
  }
  wire::LocalizeGetParticles particles;
  if (!ReadPose(particles.mean)) return false;
  particles.particles.push_back({particles.mean, 1.0});
  reply.Set(std::move(particles));
  return true;
}

DriverDef TruePlace(const std::string& robot) {
  DriverDef def;
  def.name = "fakelocalize";
  def.provided = {{"", "localize", 0}};
  def.required = {{"", "simulation", 0}};
  def.robot = robot;
  def.may_fail = true;
  return def;
}

}  // namespace ccmorse::servers::player
