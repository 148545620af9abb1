#include "libplayerc++/ranging.h"

#include <algorithm>
#include <cmath>

#include "client/player/proxy_state.h"

namespace PlayerCc {

namespace {

constexpr double kScannerSize = 0.15;  // m, what Player assumes before it was told

class BumperState : public ProxyState {
 public:
  wire::BumperData data;
  wire::BumperGeom geom;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    if (subtype == PLAYER_BUMPER_DATA_STATE) return Keep(body, data);
    return subtype == PLAYER_BUMPER_DATA_GEOM && Keep(body, geom);
  }
};

class IrState : public SimpleState<wire::IrData, PLAYER_IR_DATA_RANGES> {
 public:
  wire::IrPose geom;
};

class LaserState : public ProxyState {
 public:
  LaserState() { geom.size = {kScannerSize, kScannerSize, 0.0}; }

  wire::LaserData scan;
  std::vector<double> angles;  // of a scan whose beams are not evenly spread; else empty
  wire::Pose2d robot;
  wire::LaserConfig config;
  wire::LaserGeom geom;
  int id = -1;

  double Bearing(std::size_t i) const {
    return i < angles.size() ? angles[i]
                             : scan.min_angle + static_cast<double>(i) * scan.resolution;
  }

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    if (subtype == PLAYER_LASER_DATA_SCAN) {
      if (!Keep(body, scan)) return false;
      angles.clear();
      return true;
    }
    if (subtype == PLAYER_LASER_DATA_SCANPOSE) {
      if (!Keep(body, posed_)) return false;
      std::swap(scan, posed_.scan);
      robot = posed_.pose;
      angles.clear();
      return true;
    }
    if (subtype != PLAYER_LASER_DATA_SCANANGLE || !Keep(body, spread_)) return false;
    angles = spread_.angles;
    scan.ranges = spread_.ranges;
    scan.intensity = spread_.intensity;
    scan.max_range = spread_.max_range;
    scan.id = spread_.id;
    scan.resolution = 0.0;
    scan.min_angle = angles.empty() ? 0.0 : angles.front();
    scan.max_angle = angles.empty() ? 0.0 : angles.back();
    return true;
  }

 private:
  wire::LaserDataScanpose posed_;
  wire::LaserDataScanangle spread_;
};

using PointcloudState = SimpleState<wire::Pointcloud3dData, PLAYER_POINTCLOUD3D_DATA_STATE>;

class RangerState : public ProxyState {
 public:
  wire::RangerDataRange ranges;
  wire::RangerDataIntns intensities;
  wire::RangerGeom geom;
  wire::RangerConfig config;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    switch (subtype) {
      case PLAYER_RANGER_DATA_RANGE:
        return Keep(body, ranges);
      case PLAYER_RANGER_DATA_INTNS:
        return Keep(body, intensities);
      case PLAYER_RANGER_DATA_GEOM:
        return Keep(body, geom);
      case PLAYER_RANGER_DATA_RANGESTAMPED: {
        wire::RangerDataRangestamped stamped;
        if (!body.To(stamped)) return false;
        ranges = std::move(stamped.data);
        TakeStamps(stamped);
        return true;
      }
      case PLAYER_RANGER_DATA_INTNSSTAMPED: {
        wire::RangerDataIntnsstamped stamped;
        if (!body.To(stamped)) return false;
        intensities = std::move(stamped.data);
        TakeStamps(stamped);
        return true;
      }
      default:
        return false;
    }
  }

 private:
  template <typename Stamped>
  void TakeStamps(Stamped& stamped) {
    if (stamped.have_geom != 0) geom = std::move(stamped.geom);
    if (stamped.have_config != 0) config = stamped.config;
  }
};

class SonarState : public ProxyState {
 public:
  wire::SonarData data;
  wire::SonarGeom geom;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    if (subtype == PLAYER_SONAR_DATA_RANGES) return Keep(body, data);
    return subtype == PLAYER_SONAR_DATA_GEOM && Keep(body, geom);
  }
};

}  // namespace

// --- BumperProxy

BumperProxy::BumperProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "BumperProxy", "bumper", std::make_shared<BumperState>()) {}
BumperProxy::~BumperProxy() = default;

std::uint32_t BumperProxy::GetCount() const { return Count(In<BumperState>()->data.bumpers); }
std::uint32_t BumperProxy::IsBumped(std::uint32_t index) const {
  return At(In<BumperState>()->data.bumpers, index, "BumperProxy::IsBumped()");
}
bool BumperProxy::IsAnyBumped() {
  const auto state = In<BumperState>();
  return std::any_of(state->data.bumpers.begin(), state->data.bumpers.end(),
                     [](std::uint8_t bumper) { return bumper != 0; });
}
void BumperProxy::RequestBumperConfig() {
  wire::BumperGeom geom;
  Require(AskFor(*state_, PLAYER_BUMPER_REQ_GET_GEOM, geom), "BumperProxy::RequestBumperConfig()");
  In<BumperState>()->geom = geom;
}
std::uint32_t BumperProxy::GetPoseCount() const {
  return Count(In<BumperState>()->geom.bumper_def);
}
player_bumper_define_t BumperProxy::GetPose(std::uint32_t index) const {
  const auto state = In<BumperState>();
  const wire::BumperDefine& bumper = At(state->geom.bumper_def, index, "BumperProxy::GetPose()");
  return {ToC(bumper.pose), static_cast<float>(bumper.length), static_cast<float>(bumper.radius)};
}
bool BumperProxy::operator[](std::uint32_t index) const { return IsBumped(index) != 0; }

// --- IrProxy

IrProxy::IrProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "IrProxy", "ir", std::make_shared<IrState>()) {}
IrProxy::~IrProxy() = default;

std::uint32_t IrProxy::GetCount() const { return Count(In<IrState>()->data.ranges); }
double IrProxy::GetRange(std::uint32_t index) const {
  return At(In<IrState>()->data.ranges, index, "IrProxy::GetRange()");
}
double IrProxy::GetVoltage(std::uint32_t index) const {
  return At(In<IrState>()->data.voltages, index, "IrProxy::GetVoltage()");
}
std::uint32_t IrProxy::GetPoseCount() const { return Count(In<IrState>()->geom.poses); }
player_pose3d_t IrProxy::GetPose(std::uint32_t index) const {
  return ToC(At(In<IrState>()->geom.poses, index, "IrProxy::GetPose()"));
}
void IrProxy::RequestGeom() {
  wire::IrPose geom;
  Require(AskFor(*state_, PLAYER_IR_REQ_POSE, geom), "IrProxy::RequestGeom()");
  In<IrState>()->geom = geom;
}
double IrProxy::operator[](std::uint32_t index) const { return GetRange(index); }

// --- LaserProxy

LaserProxy::LaserProxy(PlayerClient* client, std::uint32_t index) : LaserProxy(client, index, "") {}
LaserProxy::LaserProxy(PlayerClient* client, std::uint32_t index, const std::string& robot)
    : ClientProxy(client, index, "LaserProxy", "laser", std::make_shared<LaserState>(), robot) {}
LaserProxy::~LaserProxy() = default;

std::uint32_t LaserProxy::GetCount() const { return Count(In<LaserState>()->scan.ranges); }
double LaserProxy::GetMaxRange() const { return In<LaserState>()->scan.max_range; }
double LaserProxy::GetScanRes() const { return In<LaserState>()->scan.resolution; }
double LaserProxy::GetRangeRes() const { return In<LaserState>()->config.range_res; }
double LaserProxy::GetScanningFrequency() const {
  return In<LaserState>()->config.scanning_frequency;
}
double LaserProxy::GetMinAngle() const { return In<LaserState>()->scan.min_angle; }
double LaserProxy::GetMaxAngle() const {
  const auto state = In<LaserState>();
  const std::size_t count = state->scan.ranges.size();
  return count == 0 ? state->scan.max_angle : state->Bearing(count - 1);
}
double LaserProxy::GetConfMinAngle() const { return In<LaserState>()->config.min_angle; }
double LaserProxy::GetConfMaxAngle() const { return In<LaserState>()->config.max_angle; }
bool LaserProxy::IntensityOn() const { return In<LaserState>()->config.intensity != 0; }
player_point_2d_t LaserProxy::GetPoint(std::uint32_t index) const {
  const auto state = In<LaserState>();
  const double range = At(state->scan.ranges, index, "LaserProxy::GetPoint()");
  const double bearing = state->Bearing(index);
  return {range * std::cos(bearing), range * std::sin(bearing)};
}
double LaserProxy::GetRange(std::uint32_t index) const {
  return At(In<LaserState>()->scan.ranges, index, "LaserProxy::GetRange()");
}
double LaserProxy::GetBearing(std::uint32_t index) const {
  return In<LaserState>()->Bearing(index);
}
int LaserProxy::GetIntensity(std::uint32_t index) const {
  const auto state = In<LaserState>();
  At(state->scan.ranges, index, "LaserProxy::GetIntensity()");
  return index < state->scan.intensity.size() ? state->scan.intensity[index] : 0;
}
int LaserProxy::GetID() const { return In<LaserState>()->id; }
void LaserProxy::Configure(double min_angle, double max_angle, std::uint32_t scan_res,
                           std::uint32_t range_res, bool intensity, double scanning_frequency) {
  wire::LaserConfig config;
  config.min_angle = min_angle;
  config.max_angle = max_angle;
  config.resolution = scan_res;
  config.max_range = GetMaxRange();
  config.range_res = range_res;
  config.intensity = Flag(intensity);
  config.scanning_frequency = scanning_frequency;
  Require(Ask(*state_, PLAYER_LASER_REQ_SET_CONFIG, config), "LaserProxy::Configure()");
  In<LaserState>()->config = config;
}
void LaserProxy::RequestConfigure() {
  wire::LaserConfig config;
  Require(AskFor(*state_, PLAYER_LASER_REQ_GET_CONFIG, config), "LaserProxy::RequestConfigure()");
  In<LaserState>()->config = config;
}
void LaserProxy::RequestID() {
  wire::LaserGetIdConfig id;
  Require(AskFor(*state_, PLAYER_LASER_REQ_GET_ID, id), "LaserProxy::RequestID()");
  In<LaserState>()->id = static_cast<int>(id.serial_number);
}
void LaserProxy::RequestGeom() {
  wire::LaserGeom geom;
  Require(AskFor(*state_, PLAYER_LASER_REQ_GET_GEOM, geom), "LaserProxy::RequestGeom()");
  In<LaserState>()->geom = geom;
}
player_pose3d_t LaserProxy::GetPose() { return ToC(In<LaserState>()->geom.pose); }
player_pose3d_t LaserProxy::GetRobotPose() {
  const auto state = In<LaserState>();
  return {state->robot.px, state->robot.py, 0.0, 0.0, 0.0, state->robot.pa};
}
player_bbox3d_t LaserProxy::GetSize() { return ToC(In<LaserState>()->geom.size); }
double LaserProxy::GetMinLeft() const {
  const auto state = In<LaserState>();
  const std::vector<double>& ranges = state->scan.ranges;
  double shortest = state->scan.max_range;
  for (std::size_t i = ranges.size() / 2 + 1; i < ranges.size(); ++i) {
    shortest = std::min(shortest, ranges[i]);
  }
  return shortest;
}
double LaserProxy::GetMinRight() const {
  const auto state = In<LaserState>();
  const std::vector<double>& ranges = state->scan.ranges;
  double shortest = state->scan.max_range;
  for (std::size_t i = 0; i < ranges.size() && i <= ranges.size() / 2; ++i) {
    shortest = std::min(shortest, ranges[i]);
  }
  return shortest;
}
double LaserProxy::MinLeft() const { return GetMinLeft(); }
double LaserProxy::MinRight() const { return GetMinRight(); }
double LaserProxy::operator[](std::uint32_t index) const { return GetRange(index); }

// --- Pointcloud3dProxy

Pointcloud3dProxy::Pointcloud3dProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "Pointcloud3dProxy", "pointcloud3d",
                  std::make_shared<PointcloudState>()) {}
Pointcloud3dProxy::~Pointcloud3dProxy() = default;

std::uint32_t Pointcloud3dProxy::GetCount() const {
  return Count(In<PointcloudState>()->data.points);
}
player_pointcloud3d_element_t Pointcloud3dProxy::GetPoint(std::uint32_t index) const {
  const auto state = In<PointcloudState>();
  const wire::Pointcloud3dElement& each =
      At(state->data.points, index, "Pointcloud3dProxy::GetPoint()");
  return {ToC(each.point), ToC(each.color)};
}
player_pointcloud3d_element_t Pointcloud3dProxy::operator[](std::uint32_t index) const {
  return GetPoint(index);
}

// --- RangerProxy

RangerProxy::RangerProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "RangerProxy", "ranger", std::make_shared<RangerState>()) {
  // Points need both; a driver that does not tell works all the same.
  wire::RangerConfig config;
  if (AskFor(*state_, PLAYER_RANGER_REQ_GET_CONFIG, config).ok()) {
    In<RangerState>()->config = config;
  }
  wire::RangerGeom geom;
  if (AskFor(*state_, PLAYER_RANGER_REQ_GET_GEOM, geom).ok()) In<RangerState>()->geom = geom;
}
RangerProxy::~RangerProxy() = default;

std::uint32_t RangerProxy::GetElementCount() const {
  return Count(In<RangerState>()->geom.element_poses);
}
player_pose3d_t RangerProxy::GetDevicePose() const { return ToC(In<RangerState>()->geom.pose); }
player_bbox3d_t RangerProxy::GetDeviceSize() const { return ToC(In<RangerState>()->geom.size); }
player_pose3d_t RangerProxy::GetElementPose(std::uint32_t index) const {
  return ToC(At(In<RangerState>()->geom.element_poses, index, "RangerProxy::GetElementPose()"));
}
player_bbox3d_t RangerProxy::GetElementSize(std::uint32_t index) const {
  return ToC(At(In<RangerState>()->geom.element_sizes, index, "RangerProxy::GetElementSize()"));
}
std::uint32_t RangerProxy::GetRangeCount() const { return Count(In<RangerState>()->ranges.ranges); }
double RangerProxy::GetRange(std::uint32_t index) const {
  return At(In<RangerState>()->ranges.ranges, index, "RangerProxy::GetRange()");
}
double RangerProxy::operator[](std::uint32_t index) const { return GetRange(index); }
std::uint32_t RangerProxy::GetPointCount() const { return GetRangeCount(); }
player_point_3d_t RangerProxy::GetPoint(std::uint32_t index) const {
  const auto state = In<RangerState>();
  const double range = At(state->ranges.ranges, index, "RangerProxy::GetPoint()");
  // Elements share the readings evenly; those of one element are spread from its least angle on.
  const std::vector<wire::Pose3d>& elements = state->geom.element_poses;
  const std::size_t each =
      elements.empty() ? state->ranges.ranges.size()
                       : std::max<std::size_t>(1, state->ranges.ranges.size() / elements.size());
  const std::size_t element = std::min<std::size_t>(index / each, elements.size());
  const wire::Pose3d pose = element < elements.size() ? elements[element] : wire::Pose3d();
  double yaw = pose.pyaw;
  if (each > 1) {
    yaw += state->config.min_angle +
           static_cast<double>(index - element * each) * state->config.angular_res;
  }
  const double level = range * std::cos(pose.ppitch);
  return {pose.px + level * std::cos(yaw), pose.py + level * std::sin(yaw),
          pose.pz - range * std::sin(pose.ppitch)};
}
std::uint32_t RangerProxy::GetIntensityCount() const {
  return Count(In<RangerState>()->intensities.intensities);
}
double RangerProxy::GetIntensity(std::uint32_t index) const {
  return At(In<RangerState>()->intensities.intensities, index, "RangerProxy::GetIntensity()");
}
void RangerProxy::SetPower(bool enable) {
  Require(Ask(*state_, PLAYER_RANGER_REQ_POWER, wire::RangerPowerConfig{Flag(enable)}),
          "RangerProxy::SetPower()");
}
void RangerProxy::SetIntensityData(bool enable) {
  Require(Ask(*state_, PLAYER_RANGER_REQ_INTNS, wire::RangerIntnsConfig{Flag(enable)}),
          "RangerProxy::SetIntensityData()");
}
void RangerProxy::RequestGeom() {
  wire::RangerGeom geom;
  Require(AskFor(*state_, PLAYER_RANGER_REQ_GET_GEOM, geom), "RangerProxy::RequestGeom()");
  In<RangerState>()->geom = geom;
}
void RangerProxy::Configure(double min_angle, double max_angle, double angular_res,
                            double min_range, double max_range, double range_res,
                            double frequency) {
  const wire::RangerConfig config{min_angle, max_angle, angular_res, min_range,
                                  max_range, range_res, frequency};
  Require(Ask(*state_, PLAYER_RANGER_REQ_SET_CONFIG, config), "RangerProxy::Configure()");
  In<RangerState>()->config = config;
}
void RangerProxy::RequestConfigure() {
  wire::RangerConfig config;
  Require(AskFor(*state_, PLAYER_RANGER_REQ_GET_CONFIG, config), "RangerProxy::RequestConfigure()");
  In<RangerState>()->config = config;
}
double RangerProxy::GetMinAngle() const { return In<RangerState>()->config.min_angle; }
double RangerProxy::GetMaxAngle() const { return In<RangerState>()->config.max_angle; }
double RangerProxy::GetAngularRes() const { return In<RangerState>()->config.angular_res; }
double RangerProxy::GetMinRange() const { return In<RangerState>()->config.min_range; }
double RangerProxy::GetMaxRange() const { return In<RangerState>()->config.max_range; }
double RangerProxy::GetRangeRes() const { return In<RangerState>()->config.range_res; }
double RangerProxy::GetFrequency() const { return In<RangerState>()->config.frequency; }

// --- SonarProxy

SonarProxy::SonarProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "SonarProxy", "sonar", std::make_shared<SonarState>()) {}
SonarProxy::~SonarProxy() = default;

std::uint32_t SonarProxy::GetCount() const { return Count(In<SonarState>()->data.ranges); }
double SonarProxy::GetScan(std::uint32_t index) const {
  const auto state = In<SonarState>();
  return index < state->data.ranges.size() ? state->data.ranges[index] : -1.0;
}
double SonarProxy::operator[](std::uint32_t index) const { return GetScan(index); }
std::uint32_t SonarProxy::GetPoseCount() const { return Count(In<SonarState>()->geom.poses); }
player_pose3d_t SonarProxy::GetPose(std::uint32_t index) const {
  return ToC(At(In<SonarState>()->geom.poses, index, "SonarProxy::GetPose()"));
}
void SonarProxy::RequestGeom() {
  wire::SonarGeom geom;
  if (AskFor(*state_, PLAYER_SONAR_REQ_GET_GEOM, geom).ok()) In<SonarState>()->geom = geom;
}

}  // namespace PlayerCc
