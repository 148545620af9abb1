#include "libplayerc++/motion.h"

#include "client/player/proxy_state.h"

namespace PlayerCc {

namespace {

class ActArrayState : public SimpleState<wire::ActarrayData, PLAYER_ACTARRAY_DATA_STATE> {
 public:
  wire::ActarrayGeom geom;
};

class GripperState : public SimpleState<wire::GripperData, PLAYER_GRIPPER_DATA_STATE> {
 public:
  wire::GripperGeom geom;
};

class LimbState : public SimpleState<wire::LimbData, PLAYER_LIMB_DATA_STATE> {
 public:
  wire::LimbGeomReq geom;
};

class Position1dState : public ProxyState {
 public:
  wire::Position1dData data;
  wire::Position1dGeom geom;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    if (subtype == PLAYER_POSITION1D_DATA_STATE) return Keep(body, data);
    return subtype == PLAYER_POSITION1D_DATA_GEOM && Keep(body, geom);
  }
};

class Position2dState : public ProxyState {
 public:
  wire::Position2dData data;
  wire::Position2dGeom geom;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    if (subtype == PLAYER_POSITION2D_DATA_STATE) return Keep(body, data);
    return subtype == PLAYER_POSITION2D_DATA_GEOM && Keep(body, geom);
  }
};

class Position3dState : public ProxyState {
 public:
  wire::Position3dData data;
  wire::Position3dGeom geom;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    if (subtype == PLAYER_POSITION3D_DATA_STATE) return Keep(body, data);
    return subtype == PLAYER_POSITION3D_DATA_GEOMETRY && Keep(body, geom);
  }
};

using PtzState = SimpleState<wire::PtzData, PLAYER_PTZ_DATA_STATE>;

std::vector<double> Doubles(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

// --- ActArrayProxy

ActArrayProxy::ActArrayProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "ActArrayProxy", "actarray", std::make_shared<ActArrayState>()) {}
ActArrayProxy::~ActArrayProxy() = default;

void ActArrayProxy::RequestGeometry() {
  wire::ActarrayGeom geom;
  Require(AskFor(*state_, PLAYER_ACTARRAY_REQ_GET_GEOM, geom), "ActArrayProxy::RequestGeometry()");
  In<ActArrayState>()->geom = geom;
}
void ActArrayProxy::SetPowerConfig(bool val) {
  Require(Ask(*state_, PLAYER_ACTARRAY_REQ_POWER, wire::ActarrayPowerConfig{Flag(val)}),
          "ActArrayProxy::SetPowerConfig()");
}
void ActArrayProxy::SetBrakesConfig(bool val) {
  Require(Ask(*state_, PLAYER_ACTARRAY_REQ_BRAKES, wire::ActarrayBrakesConfig{Flag(val)}),
          "ActArrayProxy::SetBrakesConfig()");
}
void ActArrayProxy::SetSpeedConfig(std::uint32_t joint, float speed) {
  Require(Ask(*state_, PLAYER_ACTARRAY_REQ_SPEED,
              wire::ActarraySpeedConfig{static_cast<std::int32_t>(joint), speed}),
          "ActArrayProxy::SetSpeedConfig()");
}
void ActArrayProxy::SetAccelerationConfig(std::uint32_t joint, float acc) {
  Require(Ask(*state_, PLAYER_ACTARRAY_REQ_ACCEL,
              wire::ActarrayAccelConfig{static_cast<std::int32_t>(joint), acc}),
          "ActArrayProxy::SetAccelerationConfig()");
}
void ActArrayProxy::MoveTo(std::uint32_t joint, float pos) {
  Command(*state_, PLAYER_ACTARRAY_CMD_POS,
          wire::ActarrayPositionCmd{static_cast<std::int32_t>(joint), pos});
}
// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
void ActArrayProxy::MoveToMulti(std::vector<float> pos) {
  Command(*state_, PLAYER_ACTARRAY_CMD_MULTI_POS, wire::ActarrayMultiPositionCmd{Doubles(pos)});
}
void ActArrayProxy::MoveAtSpeed(std::uint32_t joint, float speed) {
  Command(*state_, PLAYER_ACTARRAY_CMD_SPEED,
          wire::ActarraySpeedCmd{static_cast<std::int32_t>(joint), speed});
}
// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
void ActArrayProxy::MoveAtSpeedMulti(std::vector<float> speed) {
  Command(*state_, PLAYER_ACTARRAY_CMD_MULTI_SPEED, wire::ActarrayMultiSpeedCmd{Doubles(speed)});
}
void ActArrayProxy::MoveHome(int joint) {
  Command(*state_, PLAYER_ACTARRAY_CMD_HOME, wire::ActarrayHomeCmd{joint});
}
void ActArrayProxy::SetActuatorCurrent(std::uint32_t joint, float current) {
  Command(*state_, PLAYER_ACTARRAY_CMD_CURRENT,
          wire::ActarrayCurrentCmd{static_cast<std::int32_t>(joint), current});
}
// NOLINTNEXTLINE(performance-unnecessary-value-param): Player's own type
void ActArrayProxy::SetActuatorCurrentMulti(std::vector<float> current) {
  Command(*state_, PLAYER_ACTARRAY_CMD_MULTI_CURRENT,
          wire::ActarrayMultiCurrentCmd{Doubles(current)});
}
std::uint32_t ActArrayProxy::GetCount() const {
  return static_cast<std::uint32_t>(In<ActArrayState>()->data.actuators.size());
}
player_actarray_actuator_t ActArrayProxy::GetActuatorData(std::uint32_t joint) const {
  const auto state = In<ActArrayState>();
  const wire::ActarrayActuator& each =
      At(state->data.actuators, joint, "ActArrayProxy::GetActuatorData()");
  return {Single(each.position), Single(each.speed), Single(each.acceleration),
          Single(each.current), each.state};
}
player_actarray_actuatorgeom_t ActArrayProxy::GetActuatorGeom(std::uint32_t joint) const {
  const auto state = In<ActArrayState>();
  const wire::ActarrayActuatorgeom& each =
      At(state->geom.actuators, joint, "ActArrayProxy::GetActuatorGeom()");
  return {each.type,        Single(each.length), ToC(each.orientation),
          ToC(each.axis),   Single(each.min),    Single(each.centre),
          Single(each.max), Single(each.home),   Single(each.config_speed),
          each.hasbrakes};
}
player_point_3d_t ActArrayProxy::GetBasePos() const {
  return ToC(In<ActArrayState>()->geom.base_pos);
}
player_orientation_3d_t ActArrayProxy::GetBaseOrientation() const {
  return ToC(In<ActArrayState>()->geom.base_orientation);
}
player_actarray_actuator_t ActArrayProxy::operator[](std::uint32_t joint) {
  return GetActuatorData(joint);
}

// --- GripperProxy

GripperProxy::GripperProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "GripperProxy", "gripper", std::make_shared<GripperState>()) {}
GripperProxy::~GripperProxy() = default;

void GripperProxy::RequestGeometry() {
  wire::GripperGeom geom;
  Require(AskFor(*state_, PLAYER_GRIPPER_REQ_GET_GEOM, geom), "GripperProxy::RequestGeometry()");
  In<GripperState>()->geom = geom;
}
std::uint32_t GripperProxy::GetState() const { return In<GripperState>()->data.state; }
std::uint32_t GripperProxy::GetBeams() const { return In<GripperState>()->data.beams; }
player_pose3d_t GripperProxy::GetPose() const { return ToC(In<GripperState>()->geom.pose); }
player_bbox3d_t GripperProxy::GetOuterSize() const {
  return ToC(In<GripperState>()->geom.outer_size);
}
player_bbox3d_t GripperProxy::GetInnerSize() const {
  return ToC(In<GripperState>()->geom.inner_size);
}
std::uint32_t GripperProxy::GetNumBeams() const { return In<GripperState>()->geom.num_beams; }
std::uint32_t GripperProxy::GetCapacity() const { return In<GripperState>()->geom.capacity; }
std::uint32_t GripperProxy::GetStored() const { return In<GripperState>()->data.stored; }
void GripperProxy::Open() { Command(*state_, PLAYER_GRIPPER_CMD_OPEN); }
void GripperProxy::Close() { Command(*state_, PLAYER_GRIPPER_CMD_CLOSE); }
void GripperProxy::Stop() { Command(*state_, PLAYER_GRIPPER_CMD_STOP); }
void GripperProxy::Store() { Command(*state_, PLAYER_GRIPPER_CMD_STORE); }
void GripperProxy::Retrieve() { Command(*state_, PLAYER_GRIPPER_CMD_RETRIEVE); }

// --- LimbProxy

LimbProxy::LimbProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "LimbProxy", "limb", std::make_shared<LimbState>()) {}
LimbProxy::~LimbProxy() = default;

void LimbProxy::RequestGeometry() {
  wire::LimbGeomReq geom;
  Require(AskFor(*state_, PLAYER_LIMB_REQ_GEOM, geom), "LimbProxy::RequestGeometry()");
  In<LimbState>()->geom = geom;
}
void LimbProxy::SetPowerConfig(bool val) {
  Require(Ask(*state_, PLAYER_LIMB_REQ_POWER, wire::LimbPowerReq{Flag(val)}),
          "LimbProxy::SetPowerConfig()");
}
void LimbProxy::SetBrakesConfig(bool val) {
  Require(Ask(*state_, PLAYER_LIMB_REQ_BRAKES, wire::LimbBrakesReq{Flag(val)}),
          "LimbProxy::SetBrakesConfig()");
}
void LimbProxy::SetSpeedConfig(float speed) {
  Require(Ask(*state_, PLAYER_LIMB_REQ_SPEED, wire::LimbSpeedReq{speed}),
          "LimbProxy::SetSpeedConfig()");
}
void LimbProxy::MoveHome() { Command(*state_, PLAYER_LIMB_CMD_HOME); }
void LimbProxy::Stop() { Command(*state_, PLAYER_LIMB_CMD_STOP); }
void LimbProxy::SetPose(float px, float py, float pz, float ax, float ay, float az, float ox,
                        float oy, float oz) {
  Command(*state_, PLAYER_LIMB_CMD_SETPOSE,
          wire::LimbSetposeCmd{{px, py, pz}, {ax, ay, az}, {ox, oy, oz}});
}
void LimbProxy::SetPosition(float x, float y, float z) {
  Command(*state_, PLAYER_LIMB_CMD_SETPOSITION, wire::LimbSetpositionCmd{{x, y, z}});
}
void LimbProxy::VectorMove(float x, float y, float z, float length) {
  Command(*state_, PLAYER_LIMB_CMD_VECMOVE, wire::LimbVecmoveCmd{{x, y, z}, length});
}
player_limb_data_t LimbProxy::GetData() const {
  const auto state = In<LimbState>();
  return {ToC(state->data.position), ToC(state->data.approach), ToC(state->data.orientation),
          state->data.state};
}
player_limb_geom_req_t LimbProxy::GetGeom() const { return {ToC(In<LimbState>()->geom.basePos)}; }

// --- Position1dProxy

Position1dProxy::Position1dProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "Position1dProxy", "position1d",
                  std::make_shared<Position1dState>()) {}
Position1dProxy::~Position1dProxy() = default;

void Position1dProxy::SetSpeed(double vel) {
  Command(*state_, PLAYER_POSITION1D_CMD_VEL, wire::Position1dCmdVel{vel, 1});
}
void Position1dProxy::GoTo(double pos, double vel) {
  Command(*state_, PLAYER_POSITION1D_CMD_POS, wire::Position1dCmdPos{pos, vel, 1});
}
void Position1dProxy::RequestGeom() {
  wire::Position1dGeom geom;
  Require(AskFor(*state_, PLAYER_POSITION1D_REQ_GET_GEOM, geom), "Position1dProxy::RequestGeom()");
  In<Position1dState>()->geom = geom;
}
player_pose3d_t Position1dProxy::GetPose() const { return ToC(In<Position1dState>()->geom.pose); }
player_bbox3d_t Position1dProxy::GetSize() const { return ToC(In<Position1dState>()->geom.size); }
void Position1dProxy::SetMotorEnable(bool enable) {
  Ask(*state_, PLAYER_POSITION1D_REQ_MOTOR_POWER, wire::Position1dPowerConfig{Flag(enable)});
}
void Position1dProxy::SetOdometry(double pos) {
  Ask(*state_, PLAYER_POSITION1D_REQ_SET_ODOM, wire::Position1dSetOdomReq{pos});
}
void Position1dProxy::ResetOdometry() { SetOdometry(0.0); }
double Position1dProxy::GetPos() const { return In<Position1dState>()->data.pos; }
double Position1dProxy::GetVel() const { return In<Position1dState>()->data.vel; }
bool Position1dProxy::GetStall() const { return In<Position1dState>()->data.stall != 0; }
std::uint8_t Position1dProxy::GetStatus() const { return In<Position1dState>()->data.status; }
bool Position1dProxy::IsLimitMin() const {
  return (GetStatus() >> PLAYER_POSITION1D_STATUS_LIMIT_MIN & 1) != 0;
}
bool Position1dProxy::IsLimitCen() const {
  return (GetStatus() >> PLAYER_POSITION1D_STATUS_LIMIT_CEN & 1) != 0;
}
bool Position1dProxy::IsLimitMax() const {
  return (GetStatus() >> PLAYER_POSITION1D_STATUS_LIMIT_MAX & 1) != 0;
}
bool Position1dProxy::IsOverCurrent() const {
  return (GetStatus() >> PLAYER_POSITION1D_STATUS_OC & 1) != 0;
}
bool Position1dProxy::IsTrajComplete() const {
  return (GetStatus() >> PLAYER_POSITION1D_STATUS_TRAJ_COMPLETE & 1) != 0;
}
bool Position1dProxy::IsEnabled() const {
  return (GetStatus() >> PLAYER_POSITION1D_STATUS_ENABLED & 1) != 0;
}

// --- Position2dProxy

Position2dProxy::Position2dProxy(PlayerClient* client, std::uint32_t index)
    : Position2dProxy(client, index, "") {}
Position2dProxy::Position2dProxy(PlayerClient* client, std::uint32_t index,
                                 const std::string& robot)
    : ClientProxy(client, index, "Position2dProxy", "position2d",
                  std::make_shared<Position2dState>(), robot) {}
Position2dProxy::~Position2dProxy() = default;

void Position2dProxy::SetSpeed(double x_speed, double y_speed, double yaw_speed) {
  Command(*state_, PLAYER_POSITION2D_CMD_VEL,
          wire::Position2dCmdVel{{x_speed, y_speed, yaw_speed}, 1});
}
void Position2dProxy::SetSpeed(double x_speed, double yaw_speed) {
  SetSpeed(x_speed, 0.0, yaw_speed);
}
void Position2dProxy::SetSpeed(player_pose2d_t vel) { SetSpeed(vel.px, vel.py, vel.pa); }
void Position2dProxy::SetVelHead(double x_speed, double /*y_speed*/, double yaw_head) {
  Command(*state_, PLAYER_POSITION2D_CMD_VEL_HEAD, wire::Position2dCmdVelHead{x_speed, yaw_head});
}
void Position2dProxy::SetVelHead(double x_speed, double yaw_head) {
  SetVelHead(x_speed, 0.0, yaw_head);
}
void Position2dProxy::GoTo(player_pose2d_t pos, player_pose2d_t vel) {
  Command(*state_, PLAYER_POSITION2D_CMD_POS, wire::Position2dCmdPos{FromC(pos), FromC(vel), 1});
}
void Position2dProxy::GoTo(player_pose2d_t pos) { GoTo(pos, player_pose2d_t{}); }
void Position2dProxy::GoTo(double x, double y, double yaw) { GoTo(player_pose2d_t{x, y, yaw}); }
void Position2dProxy::SetCarlike(double x_speed, double drive_angle) {
  Command(*state_, PLAYER_POSITION2D_CMD_CAR, wire::Position2dCmdCar{x_speed, drive_angle});
}
void Position2dProxy::RequestGeom() {
  wire::Position2dGeom geom;
  Require(AskFor(*state_, PLAYER_POSITION2D_REQ_GET_GEOM, geom), "Position2dProxy::RequestGeom()");
  In<Position2dState>()->geom = geom;
}
player_pose3d_t Position2dProxy::GetOffset() { return ToC(In<Position2dState>()->geom.pose); }
player_bbox3d_t Position2dProxy::GetSize() { return ToC(In<Position2dState>()->geom.size); }
void Position2dProxy::SetMotorEnable(bool enable) {
  Ask(*state_, PLAYER_POSITION2D_REQ_MOTOR_POWER, wire::Position2dPowerConfig{Flag(enable)});
}
void Position2dProxy::ResetOdometry() { SetOdometry(0.0, 0.0, 0.0); }
void Position2dProxy::SetOdometry(double x, double y, double yaw) {
  Ask(*state_, PLAYER_POSITION2D_REQ_SET_ODOM, wire::Position2dSetOdomReq{{x, y, yaw}});
}
double Position2dProxy::GetXPos() const { return In<Position2dState>()->data.pos.px; }
double Position2dProxy::GetYPos() const { return In<Position2dState>()->data.pos.py; }
double Position2dProxy::GetYaw() const { return In<Position2dState>()->data.pos.pa; }
double Position2dProxy::GetXSpeed() const { return In<Position2dState>()->data.vel.px; }
double Position2dProxy::GetYSpeed() const { return In<Position2dState>()->data.vel.py; }
double Position2dProxy::GetYawSpeed() const { return In<Position2dState>()->data.vel.pa; }
bool Position2dProxy::GetStall() const { return In<Position2dState>()->data.stall != 0; }

// --- Position3dProxy

Position3dProxy::Position3dProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "Position3dProxy", "position3d",
                  std::make_shared<Position3dState>()) {}
Position3dProxy::~Position3dProxy() = default;

void Position3dProxy::SetSpeed(double x_speed, double y_speed, double z_speed, double roll_speed,
                               double pitch_speed, double yaw_speed) {
  Command(
      *state_, PLAYER_POSITION3D_CMD_SET_VEL,
      wire::Position3dCmdVel{{x_speed, y_speed, z_speed, roll_speed, pitch_speed, yaw_speed}, 1});
}
void Position3dProxy::SetSpeed(double x_speed, double y_speed, double z_speed, double yaw_speed) {
  SetSpeed(x_speed, y_speed, z_speed, 0.0, 0.0, yaw_speed);
}
void Position3dProxy::SetSpeed(double x_speed, double y_speed, double yaw_speed) {
  SetSpeed(x_speed, y_speed, 0.0, 0.0, 0.0, yaw_speed);
}
void Position3dProxy::SetSpeed(double x_speed, double yaw_speed) {
  SetSpeed(x_speed, 0.0, 0.0, 0.0, 0.0, yaw_speed);
}
void Position3dProxy::SetSpeed(player_pose3d_t vel) {
  SetSpeed(vel.px, vel.py, vel.pz, vel.proll, vel.ppitch, vel.pyaw);
}
void Position3dProxy::GoTo(player_pose3d_t pos, player_pose3d_t vel) {
  Command(*state_, PLAYER_POSITION3D_CMD_SET_POS,
          wire::Position3dCmdPos{FromC(pos), FromC(vel), 1});
}
void Position3dProxy::GoTo(player_pose3d_t pos) { GoTo(pos, player_pose3d_t{}); }
void Position3dProxy::GoTo(double x, double y, double z, double roll, double pitch, double yaw) {
  GoTo(player_pose3d_t{x, y, z, roll, pitch, yaw});
}
void Position3dProxy::SetMotorEnable(bool enable) {
  Ask(*state_, PLAYER_POSITION3D_REQ_MOTOR_POWER, wire::Position3dPowerConfig{Flag(enable)});
}
void Position3dProxy::SelectVelocityControl(int mode) {
  Require(Ask(*state_, PLAYER_POSITION3D_REQ_VELOCITY_MODE,
              wire::Position3dVelocityModeConfig{static_cast<std::uint32_t>(mode)}),
          "Position3dProxy::SelectVelocityControl()");
}
void Position3dProxy::ResetOdometry() { Ask(*state_, PLAYER_POSITION3D_REQ_RESET_ODOM); }
void Position3dProxy::SetOdometry(double x, double y, double z, double roll, double pitch,
                                  double yaw) {
  Ask(*state_, PLAYER_POSITION3D_REQ_SET_ODOM,
      wire::Position3dSetOdomReq{{x, y, z, roll, pitch, yaw}});
}
void Position3dProxy::RequestGeom() {
  wire::Position3dGeom geom;
  Require(AskFor(*state_, PLAYER_POSITION3D_REQ_GET_GEOM, geom), "Position3dProxy::RequestGeom()");
  In<Position3dState>()->geom = geom;
}
double Position3dProxy::GetXPos() const { return In<Position3dState>()->data.pos.px; }
double Position3dProxy::GetYPos() const { return In<Position3dState>()->data.pos.py; }
double Position3dProxy::GetZPos() const { return In<Position3dState>()->data.pos.pz; }
double Position3dProxy::GetRoll() const { return In<Position3dState>()->data.pos.proll; }
double Position3dProxy::GetPitch() const { return In<Position3dState>()->data.pos.ppitch; }
double Position3dProxy::GetYaw() const { return In<Position3dState>()->data.pos.pyaw; }
double Position3dProxy::GetXSpeed() const { return In<Position3dState>()->data.vel.px; }
double Position3dProxy::GetYSpeed() const { return In<Position3dState>()->data.vel.py; }
double Position3dProxy::GetZSpeed() const { return In<Position3dState>()->data.vel.pz; }
double Position3dProxy::GetRollSpeed() const { return In<Position3dState>()->data.vel.proll; }
double Position3dProxy::GetPitchSpeed() const { return In<Position3dState>()->data.vel.ppitch; }
double Position3dProxy::GetYawSpeed() const { return In<Position3dState>()->data.vel.pyaw; }
bool Position3dProxy::GetStall() const { return In<Position3dState>()->data.stall != 0; }

// --- PtzProxy

PtzProxy::PtzProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "PtzProxy", "ptz", std::make_shared<PtzState>()) {}
PtzProxy::~PtzProxy() = default;

void PtzProxy::SetCam(double pan, double tilt, double zoom) {
  Command(*state_, PLAYER_PTZ_CMD_STATE, wire::PtzCmd{pan, tilt, zoom, 0.0, 0.0});
}
void PtzProxy::SetSpeed(double pan_speed, double tilt_speed, double /*zoom_speed*/) {
  Command(*state_, PLAYER_PTZ_CMD_STATE, wire::PtzCmd{0.0, 0.0, 0.0, pan_speed, tilt_speed});
}
void PtzProxy::SelectControlMode(std::uint32_t mode) {
  Require(Ask(*state_, PLAYER_PTZ_REQ_CONTROL_MODE, wire::PtzReqControlMode{mode}),
          "PtzProxy::SelectControlMode()");
}
double PtzProxy::GetPan() const { return In<PtzState>()->data.pan; }
double PtzProxy::GetTilt() const { return In<PtzState>()->data.tilt; }
double PtzProxy::GetZoom() const { return In<PtzState>()->data.zoom; }
int PtzProxy::GetStatus() {
  wire::PtzReqStatus status;
  Require(AskFor(*state_, PLAYER_PTZ_REQ_STATUS, status), "PtzProxy::GetStatus()");
  return static_cast<int>(status.status);
}

}  // namespace PlayerCc
