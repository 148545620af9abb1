#include "servers/player/devices/simulation_device.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include "sim/robots/robot.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

// The box that is called "box_7"; nullptr when there is none.
const scene::Box* FindBox(const sim::Simulation& simulation, const std::string& name) {
  constexpr std::string_view kPrefix = "box_";
  if (name.compare(0, kPrefix.size(), kPrefix) != 0) return nullptr;
  int id = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + kPrefix.size(), end, id);
  if (read.ec != std::errc{} || read.ptr != end) return nullptr;
  return simulation.world().FindBox(id);
}

}  // namespace

SimulationDevice::SimulationDevice(DeviceContext context, std::uint16_t index)
    : Device(wire::kSimulation, index, "ccmorse",
             {{MessageType::kCommand, wire::kSimulationCmdPause},
              {MessageType::kCommand, wire::kSimulationCmdReset},
              {MessageType::kRequest, wire::kSimulationReqGetPose2d},
              {MessageType::kRequest, wire::kSimulationReqSetPose2d},
              {MessageType::kRequest, wire::kSimulationReqGetPose3d},
              {MessageType::kRequest, wire::kSimulationReqSetPose3d},
              {MessageType::kRequest, wire::kSimulationReqGetProperty}}),
      context_(context) {}

// Clients know the coordinates that the world's file had.
bool SimulationDevice::FindPose(const std::string& name, wire::Pose2d& pose) const {
  const Vec2 origin = context_.simulation.world().scene().origin;
  const auto tell = [&](const Pose2& found) {
    pose = {found.x - origin.x, found.y - origin.y, found.yaw};
    return true;
  };
  if (const sim::Robot* const robot = context_.simulation.FindRobot(name)) {
    return tell(robot->pose());
  }
  const scene::Box* const box = FindBox(context_.simulation, name);
  return box != nullptr && tell(box->pose);
}

bool SimulationDevice::PlaceRobot(const std::string& name, double x, double y, double yaw) const {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(yaw)) return false;
  const Vec2 origin = context_.simulation.world().scene().origin;
  const std::array<Json, 3> arguments = {Json(name),
                                         Json(Json::Array{x + origin.x, y + origin.y, 0.0}),
                                         Json(Json::Array{0.0, 0.0, yaw})};
  return context_.Run("simulation", "set_object_position", arguments);
}

bool SimulationDevice::Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  switch (subtype) {
    case wire::kSimulationReqGetPose2d:
    case wire::kSimulationReqSetPose2d: {
      wire::SimulationPose2dReq asked;
      if (!body.To(asked)) return false;
      if (subtype == wire::kSimulationReqSetPose2d) {
        return PlaceRobot(asked.name, asked.pose.px, asked.pose.py, asked.pose.pa);
      }
      if (!FindPose(asked.name, asked.pose)) return false;
      reply.Set(std::move(asked));
      return true;
    }
    case wire::kSimulationReqGetPose3d:
    case wire::kSimulationReqSetPose3d: {
      wire::SimulationPose3dReq asked;
      if (!body.To(asked)) return false;
      if (subtype == wire::kSimulationReqSetPose3d) {
        return PlaceRobot(asked.name, asked.pose.px, asked.pose.py, asked.pose.pyaw);
      }
      wire::Pose2d pose;
      if (!FindPose(asked.name, pose)) return false;
      asked.pose = {pose.px, pose.py, 0.0, 0.0, 0.0, pose.pa};
      asked.simtime = context_.simulation.time();
      reply.Set(std::move(asked));
      return true;
    }
    default:
      return GetProperty(body, reply);
  }
}

bool SimulationDevice::GetProperty(const wire::Body& body, Reply& reply) const {
  wire::SimulationPropertyReq asked;
  if (!body.To(asked) || asked.prop != "color") return false;
  const sim::Robot* const robot = context_.simulation.FindRobot(asked.name);
  const scene::Box* const box = FindBox(context_.simulation, asked.name);
  if (robot == nullptr && box == nullptr) return false;
  const Color color = robot != nullptr ? robot->def().color : box->color;
  const std::array<float, 4> parts = {static_cast<float>(color.r) / 255.0F,
                                      static_cast<float>(color.g) / 255.0F,
                                      static_cast<float>(color.b) / 255.0F, 1.0F};
  asked.value.resize(sizeof parts);
  std::memcpy(asked.value.data(), parts.data(), sizeof parts);
  reply.Set(std::move(asked));
  return true;
}

void SimulationDevice::Tell(std::uint8_t subtype, const wire::Body& /*body*/) {
  if (subtype == wire::kSimulationCmdReset) {
    context_.Run("simulation", "reset_objects");
    return;
  }
  paused_ = !paused_;
  context_.Run("simulation", paused_ ? "suspend_dynamics" : "restore_dynamics");
}

}  // namespace ccmorse::servers::player
