#include "servers/player/devices/body_sensors.h"

#include <cmath>

#include "base/trig.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr double kTravel = 0.001;  // m that a side is pressed in before its switch closes
constexpr double kVolts = 12.0;

}  // namespace

Bumper::Bumper(DeviceContext context, const sim::Robot& robot, std::uint16_t index,
               double frequency)
    : Device(wire::kBumper, index, "ccmorse",
             {{MessageType::kData, wire::kBumperDataState},
              {MessageType::kRequest, wire::kBumperReqGetGeom}}),
      context_(context),
      robot_(robot),
      rate_(frequency) {
  const std::vector<Vec2>& outline = robot.footprint().outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i];
    const Vec2 b = outline[(i + 1) % outline.size()];
    const Vec2 along = b - a;
    const double length = std::sqrt(Dot(along, along));
    const Vec2 out = (kTravel / length) * Vec2{along.y, -along.x};
    // Without its ends, which would be pressed from round the corner.
    const Vec2 end = (2.0 * kTravel / length) * along;
    sides_.push_back(sim::Footprint::Make({a + end, a + end + out, b - end + out, b - end}));
  }
}

void Bumper::Step() {
  if (!rate_.TakeDue(context_.simulation)) return;
  wire::BumperData data;
  data.bumpers.resize(sides_.size());
  if (robot_.stalled()) {
    const sim::World& world = context_.simulation.world();
    const Pose2& pose = robot_.pose();
    obstacles_.clear();
    world.NearObstacles({pose.x, pose.y}, robot_.footprint().radius + 2.0 * kTravel, obstacles_);
    for (const auto& other : context_.simulation.robots()) {
      if (other.get() != &robot_) obstacles_.push_back(&other->outline());
    }
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      data.bumpers[i] = sim::Collides(sides_[i], pose, obstacles_) ? 1 : 0;
    }
  }
  Publish(wire::kBumperDataState, context_.simulation.time(), wire::Body::Of(data));
}

bool Bumper::Ask(std::uint8_t /*subtype*/, const wire::Body& body, Reply& reply) {
  wire::BumperGeom geometry;
  const std::vector<Vec2>& outline = robot_.footprint().outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i];
    const Vec2 b = outline[(i + 1) % outline.size()];
    wire::BumperDefine side;
    // Where it looks is out of the robot.
    side.pose = {(a.x + b.x) / 2.0, (a.y + b.y) / 2.0, 0.0, 0.0, 0.0, Atan2(a.x - b.x, b.y - a.y)};
    side.length = std::hypot(b.x - a.x, b.y - a.y);
    geometry.bumper_def.push_back(side);
  }
  reply.Set(std::move(geometry));
  return body.empty();
}

Power::Power(DeviceContext context, std::uint16_t index)
    : Device(wire::kPower, index, "ccmorse",
             {{MessageType::kData, wire::kPowerDataState},
              {MessageType::kRequest, wire::kPowerReqSetChargingPolicy}}),
      context_(context),
      rate_(1.0) {}

void Power::Step() {
  if (!rate_.TakeDue(context_.simulation)) return;
  wire::PowerData data;
  data.valid = 1U | 8U;  // volts and percent
  data.volts = kVolts;
  data.percent = 100.0;
  Publish(wire::kPowerDataState, context_.simulation.time(), wire::Body::Of(data));
}

bool Power::Ask(std::uint8_t /*subtype*/, const wire::Body& body, Reply& /*reply*/) {
  wire::PowerChargepolicyConfig wanted;
  return body.To(wanted);
}

}  // namespace ccmorse::servers::player
