#include "libplayerc++/graphics.h"

#include <cstring>
#include <iostream>

#include "client/player/proxy_state.h"

namespace PlayerCc {

namespace {

// What Graphics2dProxy and Graphics3dProxy know: the pen.
class PenState : public NoState {
 public:
  wire::Color color;
};

std::vector<wire::Point2d> Points(const player_point_2d_t* points, int count) {
  std::vector<wire::Point2d> result;
  for (int i = 0; i < count; ++i) result.push_back({points[i].px, points[i].py});
  return result;
}

// SimulationProxy throws nothing.
bool Print(const Answer& answer, const char* function) {
  if (!answer.ok()) std::cerr << "error   : " << function << ": " << answer.why << "\n";
  return answer.ok();
}

}  // namespace

// --- Graphics2dProxy

Graphics2dProxy::Graphics2dProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "Graphics2dProxy", "graphics2d", std::make_shared<PenState>()) {}
Graphics2dProxy::~Graphics2dProxy() = default;

void Graphics2dProxy::Color(player_color_t col) { In<PenState>()->color = FromC(col); }
void Graphics2dProxy::Color(std::uint8_t red, std::uint8_t green, std::uint8_t blue,
                            std::uint8_t alpha) {
  In<PenState>()->color = {alpha, red, green, blue};
}
void Graphics2dProxy::Clear() { Command(*state_, PLAYER_GRAPHICS2D_CMD_CLEAR); }
void Graphics2dProxy::DrawPoints(player_point_2d_t pts[], int count) {
  Command(*state_, PLAYER_GRAPHICS2D_CMD_POINTS,
          wire::Graphics2dCmdPoints{Points(pts, count), In<PenState>()->color});
}
void Graphics2dProxy::DrawPolygon(player_point_2d_t pts[], int count, bool filled,
                                  player_color_t fill_color) {
  Command(*state_, PLAYER_GRAPHICS2D_CMD_POLYGON,
          wire::Graphics2dCmdPolygon{Points(pts, count), In<PenState>()->color, FromC(fill_color),
                                     Flag(filled)});
}
void Graphics2dProxy::DrawPolyline(player_point_2d_t pts[], int count) {
  Command(*state_, PLAYER_GRAPHICS2D_CMD_POLYLINE,
          wire::Graphics2dCmdPolyline{Points(pts, count), In<PenState>()->color});
}
void Graphics2dProxy::DrawMultiline(player_point_2d_t pts[], int count) {
  Command(*state_, PLAYER_GRAPHICS2D_CMD_MULTILINE,
          wire::Graphics2dCmdMultiline{Points(pts, count), In<PenState>()->color});
}

// --- Graphics3dProxy

Graphics3dProxy::Graphics3dProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "Graphics3dProxy", "graphics3d", std::make_shared<PenState>()) {}
Graphics3dProxy::~Graphics3dProxy() = default;

void Graphics3dProxy::Color(player_color_t col) { In<PenState>()->color = FromC(col); }
void Graphics3dProxy::Color(std::uint8_t red, std::uint8_t green, std::uint8_t blue,
                            std::uint8_t alpha) {
  In<PenState>()->color = {alpha, red, green, blue};
}
void Graphics3dProxy::Clear() { Command(*state_, PLAYER_GRAPHICS3D_CMD_CLEAR); }
void Graphics3dProxy::Draw(player_graphics3d_draw_mode_t mode, player_point_3d_t pts[], int count) {
  wire::Graphics3dCmdDraw drawing;
  drawing.draw_mode = static_cast<std::uint32_t>(mode);
  for (int i = 0; i < count; ++i) {
    drawing.points.push_back({pts[i].px, pts[i].py, pts[i].pz});
  }
  drawing.color = In<PenState>()->color;
  Command(*state_, PLAYER_GRAPHICS3D_CMD_DRAW, drawing);
}

// --- SimulationProxy

SimulationProxy::SimulationProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "SimulationProxy", "simulation", std::make_shared<NoState>()) {}
SimulationProxy::~SimulationProxy() = default;

void SimulationProxy::SetPose2d(const char* identifier, double x, double y, double a) {
  Print(Ask(*state_, PLAYER_SIMULATION_REQ_SET_POSE2D,
            wire::SimulationPose2dReq{identifier, {x, y, a}}),
        "SimulationProxy::SetPose2d()");
}
void SimulationProxy::GetPose2d(const char* identifier, double& x, double& y, double& a) {
  wire::SimulationPose2dReq request{identifier, {}};
  if (!Print(AskFor(*state_, PLAYER_SIMULATION_REQ_GET_POSE2D, wire::Body::Of(request), request),
             "SimulationProxy::GetPose2d()")) {
    return;
  }
  x = request.pose.px;
  y = request.pose.py;
  a = request.pose.pa;
}
void SimulationProxy::SetPose3d(const char* identifier, double x, double y, double z, double roll,
                                double pitch, double yaw) {
  Print(Ask(*state_, PLAYER_SIMULATION_REQ_SET_POSE3D,
            wire::SimulationPose3dReq{identifier, {x, y, z, roll, pitch, yaw}, 0.0}),
        "SimulationProxy::SetPose3d()");
}
void SimulationProxy::GetPose3d(const char* identifier, double& x, double& y, double& z,
                                double& roll, double& pitch, double& yaw, double& time) {
  wire::SimulationPose3dReq request{identifier, {}, 0.0};
  if (!Print(AskFor(*state_, PLAYER_SIMULATION_REQ_GET_POSE3D, wire::Body::Of(request), request),
             "SimulationProxy::GetPose3d()")) {
    return;
  }
  x = request.pose.px;
  y = request.pose.py;
  z = request.pose.pz;
  roll = request.pose.proll;
  pitch = request.pose.ppitch;
  yaw = request.pose.pyaw;
  time = request.simtime;
}
void SimulationProxy::GetProperty(const char* identifier, const char* name, void* value,
                                  std::size_t value_len) {
  wire::SimulationPropertyReq request{identifier, name, 0, wire::Bytes(value_len)};
  if (!Print(AskFor(*state_, PLAYER_SIMULATION_REQ_GET_PROPERTY, wire::Body::Of(request), request),
             "SimulationProxy::GetProperty()")) {
    return;
  }
  if (request.value.size() != value_len) {
    Print({Answer::Kind::kNack, "the property has another size"}, "SimulationProxy::GetProperty()");
  } else if (value_len > 0) {
    std::memcpy(value, request.value.data(), value_len);
  }
}
void SimulationProxy::SetProperty(const char* identifier, const char* name, void* value,
                                  std::size_t value_len) {
  const auto* const bytes = static_cast<const std::uint8_t*>(value);
  Print(Ask(*state_, PLAYER_SIMULATION_REQ_SET_PROPERTY,
            wire::SimulationPropertyReq{identifier, name, 0, {bytes, bytes + value_len}}),
        "SimulationProxy::SetProperty()");
}

// Player's own types, without const.
void SimulationProxy::SetPose2d(char* identifier, double x, double y, double a) {
  SetPose2d(static_cast<const char*>(identifier), x, y, a);
}
void SimulationProxy::GetPose2d(char* identifier, double& x, double& y, double& a) {
  GetPose2d(static_cast<const char*>(identifier), x, y, a);
}
void SimulationProxy::SetPose3d(char* identifier, double x, double y, double z, double roll,
                                double pitch, double yaw) {
  SetPose3d(static_cast<const char*>(identifier), x, y, z, roll, pitch, yaw);
}
void SimulationProxy::GetPose3d(char* identifier, double& x, double& y, double& z, double& roll,
                                double& pitch, double& yaw, double& time) {
  GetPose3d(static_cast<const char*>(identifier), x, y, z, roll, pitch, yaw, time);
}
void SimulationProxy::GetProperty(char* identifier, char* name, void* value,
                                  std::size_t value_len) {
  GetProperty(static_cast<const char*>(identifier), static_cast<const char*>(name), value,
              value_len);
}
void SimulationProxy::SetProperty(char* identifier, char* name, void* value,
                                  std::size_t value_len) {
  SetProperty(static_cast<const char*>(identifier), static_cast<const char*>(name), value,
              value_len);
}

}  // namespace PlayerCc
