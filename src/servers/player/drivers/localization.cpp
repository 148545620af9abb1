#include "servers/player/drivers/localization.h"

#include <array>

#include "base/error.h"
#include "base/image.h"
#include "servers/player/devices/map_device.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

navigation::OccupancyGrid ReadMap(const DriverOptions& options) {
  const std::string file = options.Text("filename", "");
  if (file.empty()) throw Error("driver mapfile: filename is missing");
  const Image image = ReadPng(file);
  const double scale = options.Length("resolution", 0.0);
  if (!(scale > 0.0)) throw Error("driver mapfile: resolution must be more than 0");
  std::array<double, 2> origin = {-0.5 * image.width * scale, -0.5 * image.height * scale};
  options.Tuple("origin", "ll", origin);
  return navigation::OccupancyGrid::FromImage(image, scale, options.Flag("negate", false),
                                              {origin[0], origin[1]});
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
