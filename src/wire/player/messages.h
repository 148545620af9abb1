#pragma once

// Made by scripts/player_messages.py from src/wire/player/interfaces.def: edit that.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ccmorse::wire::player {

// Each struct is the body of messages; Fields() hands its fields, in the order of the wire, to a
// writer or a reader (xdr.h). m, rad, s, V unless the interface says otherwise. What is a float on
// the wire is a double here.
// NOLINTBEGIN(readability-identifier-naming,readability-magic-numbers)

/// audio CMD WAV_STREAM_REC.
struct Bool {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const Bool&) const = default;
};

struct Color {
  std::uint8_t alpha = 0;
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.alpha);
    xdr.Value(m.red);
    xdr.Value(m.green);
    xdr.Value(m.blue);
  }
  bool operator==(const Color&) const = default;
};

struct Point2d {
  double px = 0;
  double py = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.px);
    xdr.Value(m.py);
  }
  bool operator==(const Point2d&) const = default;
};

struct Point3d {
  double px = 0;
  double py = 0;
  double pz = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.px);
    xdr.Value(m.py);
    xdr.Value(m.pz);
  }
  bool operator==(const Point3d&) const = default;
};

struct Orientation3d {
  double proll = 0;
  double ppitch = 0;
  double pyaw = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.proll);
    xdr.Value(m.ppitch);
    xdr.Value(m.pyaw);
  }
  bool operator==(const Orientation3d&) const = default;
};

struct Pose2d {
  double px = 0;
  double py = 0;
  double pa = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.px);
    xdr.Value(m.py);
    xdr.Value(m.pa);
  }
  bool operator==(const Pose2d&) const = default;
};

struct Pose3d {
  double px = 0;
  double py = 0;
  double pz = 0;
  double proll = 0;
  double ppitch = 0;
  double pyaw = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.px);
    xdr.Value(m.py);
    xdr.Value(m.pz);
    xdr.Value(m.proll);
    xdr.Value(m.ppitch);
    xdr.Value(m.pyaw);
  }
  bool operator==(const Pose3d&) const = default;
};

struct Bbox2d {
  double sw = 0;
  double sl = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.sw);
    xdr.Value(m.sl);
  }
  bool operator==(const Bbox2d&) const = default;
};

struct Bbox3d {
  double sw = 0;
  double sl = 0;
  double sh = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.sw);
    xdr.Value(m.sl);
    xdr.Value(m.sh);
  }
  bool operator==(const Bbox3d&) const = default;
};

struct Segment {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.x0);
    xdr.Value(m.y0);
    xdr.Value(m.x1);
    xdr.Value(m.y1);
  }
  bool operator==(const Segment&) const = default;
};

struct Extent2d {
  double x0 = 0;
  double y0 = 0;
  double x1 = 0;
  double y1 = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.x0);
    xdr.Value(m.y0);
    xdr.Value(m.x1);
    xdr.Value(m.y1);
  }
  bool operator==(const Extent2d&) const = default;
};

struct Devaddr {
  std::uint32_t host = 0;
  std::uint32_t robot = 0;
  std::uint16_t interf = 0;
  std::uint16_t index = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.host);
    xdr.Value(m.robot);
    xdr.Value(m.interf);
    xdr.Value(m.index);
  }
  bool operator==(const Devaddr&) const = default;
};

struct CapabilitiesReq {
  std::uint32_t type = 0;
  std::uint32_t subtype = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.type);
    xdr.Value(m.subtype);
  }
  bool operator==(const CapabilitiesReq&) const = default;
};

struct BoolpropReq {
  std::string key;
  std::uint8_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.key);
    xdr.Items(m.key);
    xdr.Value(m.value);
  }
  bool operator==(const BoolpropReq&) const = default;
};

struct IntpropReq {
  std::string key;
  std::int32_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.key);
    xdr.Items(m.key);
    xdr.Value(m.value);
  }
  bool operator==(const IntpropReq&) const = default;
};

struct DblpropReq {
  std::string key;
  double value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.key);
    xdr.Items(m.key);
    xdr.Value(m.value);
  }
  bool operator==(const DblpropReq&) const = default;
};

struct StrpropReq {
  std::string key;
  std::string value;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.key);
    xdr.Items(m.key);
    xdr.Count(m.value);
    xdr.Items(m.value);
  }
  bool operator==(const StrpropReq&) const = default;
};

// --- player

inline constexpr std::uint16_t kPlayer = 1;

inline constexpr std::uint8_t kPlayerReqDevlist = 1;
inline constexpr std::uint8_t kPlayerReqDriverinfo = 2;
inline constexpr std::uint8_t kPlayerReqDev = 3;
inline constexpr std::uint8_t kPlayerReqData = 4;
inline constexpr std::uint8_t kPlayerReqDatamode = 5;
inline constexpr std::uint8_t kPlayerReqAuth = 7;
inline constexpr std::uint8_t kPlayerReqNameservice = 8;
inline constexpr std::uint8_t kPlayerReqAddReplaceRule = 10;
inline constexpr std::uint8_t kPlayerSynchOk = 1;
inline constexpr std::uint8_t kPlayerSynchOverflow = 2;

/// player REQ DEVLIST.
struct DeviceDevlist {
  std::vector<Devaddr> devices;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.devices);
    xdr.Items(m.devices, 4096);
  }
  bool operator==(const DeviceDevlist&) const = default;
};

/// player REQ DRIVERINFO.
struct DeviceDriverinfo {
  Devaddr addr;
  std::string driver_name;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.addr);
    xdr.Count(m.driver_name);
    xdr.Items(m.driver_name, 64);
  }
  bool operator==(const DeviceDriverinfo&) const = default;
};

/// player REQ DEV.
struct DeviceReq {
  Devaddr addr;
  std::uint8_t access = 0;
  std::string driver_name;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.addr);
    xdr.Value(m.access);
    xdr.Count(m.driver_name);
    xdr.Items(m.driver_name, 64);
  }
  bool operator==(const DeviceReq&) const = default;
};

/// player REQ DATAMODE.
struct DeviceDatamodeReq {
  std::uint8_t mode = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.mode);
  }
  bool operator==(const DeviceDatamodeReq&) const = default;
};

/// player REQ AUTH.
struct DeviceAuthReq {
  std::string auth_key;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.auth_key);
    xdr.Items(m.auth_key, 32);
  }
  bool operator==(const DeviceAuthReq&) const = default;
};

/// player REQ NAMESERVICE.
struct DeviceNameserviceReq {
  std::string name;
  std::uint16_t port = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.name);
    xdr.Items(m.name, 64);
    xdr.Value(m.port);
  }
  bool operator==(const DeviceNameserviceReq&) const = default;
};

/// player REQ ADD_REPLACE_RULE.
struct AddReplaceRuleReq {
  std::int32_t interf = 0;
  std::int32_t index = 0;
  std::int32_t type = 0;
  std::int32_t subtype = 0;
  std::int32_t replace = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.interf);
    xdr.Value(m.index);
    xdr.Value(m.type);
    xdr.Value(m.subtype);
    xdr.Value(m.replace);
  }
  bool operator==(const AddReplaceRuleReq&) const = default;
};

/// player SYNCH OVERFLOW.
struct Overflow {
  std::uint32_t dropped = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.dropped);
  }
  bool operator==(const Overflow&) const = default;
};

// --- power

inline constexpr std::uint16_t kPower = 2;

inline constexpr std::uint8_t kPowerDataState = 1;
inline constexpr std::uint8_t kPowerReqSetChargingPolicy = 1;

/// power DATA STATE.
struct PowerData {
  std::uint32_t valid = 0;
  double volts = 0;
  double percent = 0;
  double joules = 0;
  double watts = 0;
  std::int32_t charging = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.valid);
    xdr.Single(m.volts);
    xdr.Single(m.percent);
    xdr.Single(m.joules);
    xdr.Single(m.watts);
    xdr.Value(m.charging);
  }
  bool operator==(const PowerData&) const = default;
};

/// power REQ SET_CHARGING_POLICY.
struct PowerChargepolicyConfig {
  std::uint8_t enable_input = 0;
  std::uint8_t enable_output = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.enable_input);
    xdr.Value(m.enable_output);
  }
  bool operator==(const PowerChargepolicyConfig&) const = default;
};

// --- gripper

inline constexpr std::uint16_t kGripper = 3;

inline constexpr std::uint8_t kGripperDataState = 1;
inline constexpr std::uint8_t kGripperReqGetGeom = 1;
inline constexpr std::uint8_t kGripperCmdOpen = 1;
inline constexpr std::uint8_t kGripperCmdClose = 2;
inline constexpr std::uint8_t kGripperCmdStop = 3;
inline constexpr std::uint8_t kGripperCmdStore = 4;
inline constexpr std::uint8_t kGripperCmdRetrieve = 5;

/// gripper DATA STATE.
struct GripperData {
  std::uint8_t state = 0;
  std::uint32_t beams = 0;
  std::uint8_t stored = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
    xdr.Value(m.beams);
    xdr.Value(m.stored);
  }
  bool operator==(const GripperData&) const = default;
};

/// gripper REQ GET_GEOM.
struct GripperGeom {
  Pose3d pose;
  Bbox3d outer_size;
  Bbox3d inner_size;
  std::uint8_t num_beams = 0;
  std::uint8_t capacity = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.outer_size);
    xdr.Value(m.inner_size);
    xdr.Value(m.num_beams);
    xdr.Value(m.capacity);
  }
  bool operator==(const GripperGeom&) const = default;
};

// --- position2d

inline constexpr std::uint16_t kPosition2d = 4;

inline constexpr std::uint8_t kPosition2dReqGetGeom = 1;
inline constexpr std::uint8_t kPosition2dReqMotorPower = 2;
inline constexpr std::uint8_t kPosition2dReqVelocityMode = 3;
inline constexpr std::uint8_t kPosition2dReqPositionMode = 4;
inline constexpr std::uint8_t kPosition2dReqSetOdom = 5;
inline constexpr std::uint8_t kPosition2dReqResetOdom = 6;
inline constexpr std::uint8_t kPosition2dReqSpeedPid = 7;
inline constexpr std::uint8_t kPosition2dReqPositionPid = 8;
inline constexpr std::uint8_t kPosition2dReqSpeedProf = 9;
inline constexpr std::uint8_t kPosition2dDataState = 1;
inline constexpr std::uint8_t kPosition2dDataGeom = 2;
inline constexpr std::uint8_t kPosition2dCmdVel = 1;
inline constexpr std::uint8_t kPosition2dCmdPos = 2;
inline constexpr std::uint8_t kPosition2dCmdCar = 3;
inline constexpr std::uint8_t kPosition2dCmdVelHead = 4;

/// position2d DATA STATE.
struct Position2dData {
  Pose2d pos;
  Pose2d vel;
  std::uint8_t stall = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pos);
    xdr.Value(m.vel);
    xdr.Value(m.stall);
  }
  bool operator==(const Position2dData&) const = default;
};

/// position2d CMD VEL.
struct Position2dCmdVel {
  Pose2d vel;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.vel);
    xdr.Value(m.state);
  }
  bool operator==(const Position2dCmdVel&) const = default;
};

/// position2d CMD POS.
struct Position2dCmdPos {
  Pose2d pos;
  Pose2d vel;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pos);
    xdr.Value(m.vel);
    xdr.Value(m.state);
  }
  bool operator==(const Position2dCmdPos&) const = default;
};

/// position2d CMD CAR.
struct Position2dCmdCar {
  double velocity = 0;
  double angle = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.velocity);
    xdr.Value(m.angle);
  }
  bool operator==(const Position2dCmdCar&) const = default;
};

/// position2d CMD VEL_HEAD.
struct Position2dCmdVelHead {
  double velocity = 0;
  double angle = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.velocity);
    xdr.Value(m.angle);
  }
  bool operator==(const Position2dCmdVelHead&) const = default;
};

/// position2d REQ GET_GEOM, position2d DATA GEOM.
struct Position2dGeom {
  Pose3d pose;
  Bbox3d size;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.size);
  }
  bool operator==(const Position2dGeom&) const = default;
};

/// position2d REQ MOTOR_POWER.
struct Position2dPowerConfig {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const Position2dPowerConfig&) const = default;
};

/// position2d REQ VELOCITY_MODE.
struct Position2dVelocityModeConfig {
  std::uint32_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const Position2dVelocityModeConfig&) const = default;
};

/// position2d REQ POSITION_MODE.
struct Position2dPositionModeReq {
  std::uint32_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const Position2dPositionModeReq&) const = default;
};

/// position2d REQ SET_ODOM.
struct Position2dSetOdomReq {
  Pose2d pose;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
  }
  bool operator==(const Position2dSetOdomReq&) const = default;
};

/// position2d REQ SPEED_PID.
struct Position2dSpeedPidReq {
  double kp = 0;
  double ki = 0;
  double kd = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.kp);
    xdr.Single(m.ki);
    xdr.Single(m.kd);
  }
  bool operator==(const Position2dSpeedPidReq&) const = default;
};

/// position2d REQ POSITION_PID.
struct Position2dPositionPidReq {
  double kp = 0;
  double ki = 0;
  double kd = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.kp);
    xdr.Single(m.ki);
    xdr.Single(m.kd);
  }
  bool operator==(const Position2dPositionPidReq&) const = default;
};

/// position2d REQ SPEED_PROF.
struct Position2dSpeedProfReq {
  double speed = 0;
  double acc = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.speed);
    xdr.Single(m.acc);
  }
  bool operator==(const Position2dSpeedProfReq&) const = default;
};

// --- sonar

inline constexpr std::uint16_t kSonar = 5;

inline constexpr std::uint8_t kSonarReqGetGeom = 1;
inline constexpr std::uint8_t kSonarReqPower = 2;
inline constexpr std::uint8_t kSonarDataRanges = 1;
inline constexpr std::uint8_t kSonarDataGeom = 2;

/// sonar DATA RANGES.
struct SonarData {
  std::vector<double> ranges;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.ranges);
    xdr.SingleItems(m.ranges);
  }
  bool operator==(const SonarData&) const = default;
};

/// sonar REQ GET_GEOM, sonar DATA GEOM.
struct SonarGeom {
  std::vector<Pose3d> poses;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.poses);
    xdr.Items(m.poses);
  }
  bool operator==(const SonarGeom&) const = default;
};

/// sonar REQ POWER.
struct SonarPowerConfig {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const SonarPowerConfig&) const = default;
};

// --- laser

inline constexpr std::uint16_t kLaser = 6;

inline constexpr std::uint8_t kLaserDataScan = 1;
inline constexpr std::uint8_t kLaserDataScanpose = 2;
inline constexpr std::uint8_t kLaserDataScanangle = 3;
inline constexpr std::uint8_t kLaserReqGetGeom = 1;
inline constexpr std::uint8_t kLaserReqSetConfig = 2;
inline constexpr std::uint8_t kLaserReqGetConfig = 3;
inline constexpr std::uint8_t kLaserReqPower = 4;
inline constexpr std::uint8_t kLaserReqGetId = 5;
inline constexpr std::uint8_t kLaserReqSetFilter = 6;

/// laser DATA SCAN.
struct LaserData {
  double min_angle = 0;
  double max_angle = 0;
  double resolution = 0;
  double max_range = 0;
  std::vector<double> ranges;
  std::vector<std::uint8_t> intensity;
  std::uint32_t id = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.min_angle);
    xdr.Single(m.max_angle);
    xdr.Single(m.resolution);
    xdr.Single(m.max_range);
    xdr.Count(m.ranges);
    xdr.SingleItems(m.ranges);
    xdr.Count(m.intensity);
    xdr.Items(m.intensity);
    xdr.Value(m.id);
  }
  bool operator==(const LaserData&) const = default;
};

/// laser DATA SCANPOSE.
struct LaserDataScanpose {
  LaserData scan;
  Pose2d pose;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.scan);
    xdr.Value(m.pose);
  }
  bool operator==(const LaserDataScanpose&) const = default;
};

/// laser DATA SCANANGLE.
struct LaserDataScanangle {
  double max_range = 0;
  std::vector<double> ranges;
  std::vector<double> angles;
  std::vector<std::uint8_t> intensity;
  std::uint32_t id = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.max_range);
    xdr.Count(m.ranges);
    xdr.SingleItems(m.ranges);
    xdr.Count(m.angles);
    xdr.SingleItems(m.angles);
    xdr.Count(m.intensity);
    xdr.Items(m.intensity);
    xdr.Value(m.id);
  }
  bool operator==(const LaserDataScanangle&) const = default;
};

/// laser REQ GET_GEOM.
struct LaserGeom {
  Pose3d pose;
  Bbox3d size;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.size);
  }
  bool operator==(const LaserGeom&) const = default;
};

/// laser REQ SET_CONFIG, laser REQ GET_CONFIG.
struct LaserConfig {
  double min_angle = 0;
  double max_angle = 0;
  double resolution = 0;
  double max_range = 0;
  double range_res = 0;
  std::uint8_t intensity = 0;
  double scanning_frequency = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.min_angle);
    xdr.Single(m.max_angle);
    xdr.Single(m.resolution);
    xdr.Single(m.max_range);
    xdr.Single(m.range_res);
    xdr.Value(m.intensity);
    xdr.Single(m.scanning_frequency);
  }
  bool operator==(const LaserConfig&) const = default;
};

/// laser REQ POWER.
struct LaserPowerConfig {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const LaserPowerConfig&) const = default;
};

/// laser REQ GET_ID.
struct LaserGetIdConfig {
  std::uint32_t serial_number = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.serial_number);
  }
  bool operator==(const LaserGetIdConfig&) const = default;
};

/// laser REQ SET_FILTER.
struct LaserSetFilterConfig {
  std::uint8_t filter_type = 0;
  std::vector<double> parameters;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.filter_type);
    xdr.Count(m.parameters);
    xdr.SingleItems(m.parameters, 8);
  }
  bool operator==(const LaserSetFilterConfig&) const = default;
};

// --- blobfinder

inline constexpr std::uint16_t kBlobfinder = 7;

inline constexpr std::uint8_t kBlobfinderDataBlobs = 1;
inline constexpr std::uint8_t kBlobfinderReqSetColor = 1;
inline constexpr std::uint8_t kBlobfinderReqSetImagerParams = 2;
inline constexpr std::uint8_t kBlobfinderReqGetColor = 3;

struct BlobfinderBlob {
  std::uint32_t id = 0;
  std::uint32_t color = 0;
  std::uint32_t area = 0;
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  std::uint32_t left = 0;
  std::uint32_t right = 0;
  std::uint32_t top = 0;
  std::uint32_t bottom = 0;
  double range = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.id);
    xdr.Value(m.color);
    xdr.Value(m.area);
    xdr.Value(m.x);
    xdr.Value(m.y);
    xdr.Value(m.left);
    xdr.Value(m.right);
    xdr.Value(m.top);
    xdr.Value(m.bottom);
    xdr.Single(m.range);
  }
  bool operator==(const BlobfinderBlob&) const = default;
};

/// blobfinder DATA BLOBS.
struct BlobfinderData {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<BlobfinderBlob> blobs;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.width);
    xdr.Value(m.height);
    xdr.Count(m.blobs);
    xdr.Items(m.blobs);
  }
  bool operator==(const BlobfinderData&) const = default;
};

/// blobfinder REQ SET_COLOR, blobfinder REQ GET_COLOR.
struct BlobfinderColorConfig {
  std::uint32_t channel = 0;
  std::uint32_t rmin = 0;
  std::uint32_t rmax = 0;
  std::uint32_t gmin = 0;
  std::uint32_t gmax = 0;
  std::uint32_t bmin = 0;
  std::uint32_t bmax = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.channel);
    xdr.Value(m.rmin);
    xdr.Value(m.rmax);
    xdr.Value(m.gmin);
    xdr.Value(m.gmax);
    xdr.Value(m.bmin);
    xdr.Value(m.bmax);
  }
  bool operator==(const BlobfinderColorConfig&) const = default;
};

/// blobfinder REQ SET_IMAGER_PARAMS.
struct BlobfinderImagerConfig {
  std::int32_t brightness = 0;
  std::int32_t contrast = 0;
  std::int32_t colormode = 0;
  std::int32_t autogain = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.brightness);
    xdr.Value(m.contrast);
    xdr.Value(m.colormode);
    xdr.Value(m.autogain);
  }
  bool operator==(const BlobfinderImagerConfig&) const = default;
};

// --- ptz

inline constexpr std::uint16_t kPtz = 8;

inline constexpr std::uint8_t kPtzReqGeneric = 1;
inline constexpr std::uint8_t kPtzReqControlMode = 2;
inline constexpr std::uint8_t kPtzReqGeom = 4;
inline constexpr std::uint8_t kPtzReqStatus = 5;
inline constexpr std::uint8_t kPtzDataState = 1;
inline constexpr std::uint8_t kPtzDataGeom = 2;
inline constexpr std::uint8_t kPtzCmdState = 1;

/// ptz DATA STATE.
struct PtzData {
  double pan = 0;
  double tilt = 0;
  double zoom = 0;
  double panspeed = 0;
  double tiltspeed = 0;
  std::uint32_t status = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.pan);
    xdr.Single(m.tilt);
    xdr.Single(m.zoom);
    xdr.Single(m.panspeed);
    xdr.Single(m.tiltspeed);
    xdr.Value(m.status);
  }
  bool operator==(const PtzData&) const = default;
};

/// ptz CMD STATE.
struct PtzCmd {
  double pan = 0;
  double tilt = 0;
  double zoom = 0;
  double panspeed = 0;
  double tiltspeed = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.pan);
    xdr.Single(m.tilt);
    xdr.Single(m.zoom);
    xdr.Single(m.panspeed);
    xdr.Single(m.tiltspeed);
  }
  bool operator==(const PtzCmd&) const = default;
};

/// ptz REQ STATUS.
struct PtzReqStatus {
  std::uint32_t status = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.status);
  }
  bool operator==(const PtzReqStatus&) const = default;
};

/// ptz REQ GEOM, ptz DATA GEOM.
struct PtzGeom {
  Pose3d pos;
  Bbox3d size;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pos);
    xdr.Value(m.size);
  }
  bool operator==(const PtzGeom&) const = default;
};

/// ptz REQ GENERIC.
struct PtzReqGeneric {
  std::vector<std::uint32_t> config;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.config);
    xdr.Items(m.config);
  }
  bool operator==(const PtzReqGeneric&) const = default;
};

/// ptz REQ CONTROL_MODE.
struct PtzReqControlMode {
  std::uint32_t mode = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.mode);
  }
  bool operator==(const PtzReqControlMode&) const = default;
};

// --- audio

inline constexpr std::uint16_t kAudio = 9;

inline constexpr std::uint8_t kAudioDataWavRec = 1;
inline constexpr std::uint8_t kAudioDataSeq = 2;
inline constexpr std::uint8_t kAudioDataMixerChannel = 3;
inline constexpr std::uint8_t kAudioDataState = 4;
inline constexpr std::uint8_t kAudioCmdWavPlay = 1;
inline constexpr std::uint8_t kAudioCmdWavStreamRec = 2;
inline constexpr std::uint8_t kAudioCmdSamplePlay = 3;
inline constexpr std::uint8_t kAudioCmdSeqPlay = 4;
inline constexpr std::uint8_t kAudioCmdMixerChannel = 5;
inline constexpr std::uint8_t kAudioReqWavRec = 1;
inline constexpr std::uint8_t kAudioReqSampleLoad = 2;
inline constexpr std::uint8_t kAudioReqSampleRetrieve = 3;
inline constexpr std::uint8_t kAudioReqSampleRec = 4;
inline constexpr std::uint8_t kAudioReqMixerChannelList = 5;
inline constexpr std::uint8_t kAudioReqMixerChannelLevel = 6;

/// audio DATA WAV_REC, audio CMD WAV_PLAY, audio REQ WAV_REC.
struct AudioWav {
  std::vector<std::uint8_t> data;
  std::uint32_t format = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.data);
    xdr.Items(m.data);
    xdr.Value(m.format);
  }
  bool operator==(const AudioWav&) const = default;
};

struct AudioSeqItem {
  double freq = 0;
  double duration = 0;
  double amplitude = 0;
  Bool link;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.freq);
    xdr.Single(m.duration);
    xdr.Single(m.amplitude);
    xdr.Value(m.link);
  }
  bool operator==(const AudioSeqItem&) const = default;
};

/// audio DATA SEQ, audio CMD SEQ_PLAY.
struct AudioSeq {
  std::vector<AudioSeqItem> tones;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.tones);
    xdr.Items(m.tones);
  }
  bool operator==(const AudioSeq&) const = default;
};

struct AudioMixerChannel {
  double amplitude = 0;
  Bool active;
  std::uint32_t index = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.amplitude);
    xdr.Value(m.active);
    xdr.Value(m.index);
  }
  bool operator==(const AudioMixerChannel&) const = default;
};

/// audio DATA MIXER_CHANNEL, audio CMD MIXER_CHANNEL, audio REQ MIXER_CHANNEL_LEVEL.
struct AudioMixerChannelList {
  std::vector<AudioMixerChannel> channels;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.channels);
    xdr.Items(m.channels);
  }
  bool operator==(const AudioMixerChannelList&) const = default;
};

struct AudioMixerChannelDetail {
  std::string name;
  std::uint8_t caps = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.name);
    xdr.Items(m.name);
    xdr.Value(m.caps);
  }
  bool operator==(const AudioMixerChannelDetail&) const = default;
};

/// audio REQ MIXER_CHANNEL_LIST.
struct AudioMixerChannelListDetail {
  std::vector<AudioMixerChannelDetail> details;
  std::int32_t default_output = 0;
  std::int32_t default_input = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.details);
    xdr.Items(m.details);
    xdr.Value(m.default_output);
    xdr.Value(m.default_input);
  }
  bool operator==(const AudioMixerChannelListDetail&) const = default;
};

/// audio REQ SAMPLE_LOAD, audio REQ SAMPLE_RETRIEVE.
struct AudioSample {
  AudioWav sample;
  std::int32_t index = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.sample);
    xdr.Value(m.index);
  }
  bool operator==(const AudioSample&) const = default;
};

/// audio CMD SAMPLE_PLAY, audio REQ SAMPLE_REC.
struct AudioSampleItem {
  std::int32_t index = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.index);
  }
  bool operator==(const AudioSampleItem&) const = default;
};

struct AudioSampleRecReq {
  std::int32_t index = 0;
  std::uint32_t length = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.index);
    xdr.Value(m.length);
  }
  bool operator==(const AudioSampleRecReq&) const = default;
};

/// audio DATA STATE.
struct AudioState {
  std::uint32_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const AudioState&) const = default;
};

// --- fiducial

inline constexpr std::uint16_t kFiducial = 10;

inline constexpr std::uint8_t kFiducialDataScan = 1;
inline constexpr std::uint8_t kFiducialReqGetGeom = 1;
inline constexpr std::uint8_t kFiducialReqGetFov = 2;
inline constexpr std::uint8_t kFiducialReqSetFov = 3;
inline constexpr std::uint8_t kFiducialReqGetId = 7;
inline constexpr std::uint8_t kFiducialReqSetId = 8;

struct FiducialItem {
  std::int32_t id = 0;
  Pose3d pose;
  Pose3d upose;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.id);
    xdr.Value(m.pose);
    xdr.Value(m.upose);
  }
  bool operator==(const FiducialItem&) const = default;
};

/// fiducial DATA SCAN.
struct FiducialData {
  std::vector<FiducialItem> fiducials;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.fiducials);
    xdr.Items(m.fiducials);
  }
  bool operator==(const FiducialData&) const = default;
};

/// fiducial REQ GET_GEOM.
struct FiducialGeom {
  Pose3d pose;
  Bbox3d size;
  Bbox2d fiducial_size;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.size);
    xdr.Value(m.fiducial_size);
  }
  bool operator==(const FiducialGeom&) const = default;
};

/// fiducial REQ GET_FOV, fiducial REQ SET_FOV.
struct FiducialFov {
  double min_range = 0;
  double max_range = 0;
  double view_angle = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.min_range);
    xdr.Single(m.max_range);
    xdr.Single(m.view_angle);
  }
  bool operator==(const FiducialFov&) const = default;
};

/// fiducial REQ GET_ID, fiducial REQ SET_ID.
struct FiducialId {
  std::uint32_t id = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.id);
  }
  bool operator==(const FiducialId&) const = default;
};

// --- speech

inline constexpr std::uint16_t kSpeech = 12;

inline constexpr std::uint8_t kSpeechCmdSay = 1;

/// speech CMD SAY.
struct SpeechCmd {
  std::string string;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.string);
    xdr.Items(m.string);
  }
  bool operator==(const SpeechCmd&) const = default;
};

// --- gps

inline constexpr std::uint16_t kGps = 13;

inline constexpr std::uint8_t kGpsDataState = 1;

/// gps DATA STATE.
struct GpsData {
  std::uint32_t time_sec = 0;
  std::uint32_t time_usec = 0;
  std::int32_t latitude = 0;
  std::int32_t longitude = 0;
  std::int32_t altitude = 0;
  double speed = 0;
  double course = 0;
  double utm_e = 0;
  double utm_n = 0;
  std::uint32_t quality = 0;
  std::uint32_t num_sats = 0;
  std::uint32_t hdop = 0;
  std::uint32_t vdop = 0;
  double err_horz = 0;
  double err_vert = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.time_sec);
    xdr.Value(m.time_usec);
    xdr.Value(m.latitude);
    xdr.Value(m.longitude);
    xdr.Value(m.altitude);
    xdr.Value(m.speed);
    xdr.Value(m.course);
    xdr.Value(m.utm_e);
    xdr.Value(m.utm_n);
    xdr.Value(m.quality);
    xdr.Value(m.num_sats);
    xdr.Value(m.hdop);
    xdr.Value(m.vdop);
    xdr.Value(m.err_horz);
    xdr.Value(m.err_vert);
  }
  bool operator==(const GpsData&) const = default;
};

// --- bumper

inline constexpr std::uint16_t kBumper = 14;

inline constexpr std::uint8_t kBumperDataState = 1;
inline constexpr std::uint8_t kBumperDataGeom = 2;
inline constexpr std::uint8_t kBumperReqGetGeom = 1;

/// bumper DATA STATE.
struct BumperData {
  std::vector<std::uint8_t> bumpers;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.bumpers);
    xdr.Items(m.bumpers);
  }
  bool operator==(const BumperData&) const = default;
};

struct BumperDefine {
  Pose3d pose;
  double length = 0;
  double radius = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Single(m.length);
    xdr.Single(m.radius);
  }
  bool operator==(const BumperDefine&) const = default;
};

/// bumper DATA GEOM, bumper REQ GET_GEOM.
struct BumperGeom {
  std::vector<BumperDefine> bumper_def;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.bumper_def);
    xdr.Items(m.bumper_def);
  }
  bool operator==(const BumperGeom&) const = default;
};

// --- dio

inline constexpr std::uint16_t kDio = 20;

inline constexpr std::uint8_t kDioDataValues = 1;
inline constexpr std::uint8_t kDioCmdValues = 1;

/// dio DATA VALUES.
struct DioData {
  std::uint32_t count = 0;
  std::uint32_t bits = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.count);
    xdr.Value(m.bits);
  }
  bool operator==(const DioData&) const = default;
};

/// dio CMD VALUES.
struct DioCmd {
  std::uint32_t count = 0;
  std::uint32_t digout = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.count);
    xdr.Value(m.digout);
  }
  bool operator==(const DioCmd&) const = default;
};

// --- aio

inline constexpr std::uint16_t kAio = 21;

inline constexpr std::uint8_t kAioCmdState = 1;
inline constexpr std::uint8_t kAioDataState = 1;

/// aio DATA STATE.
struct AioData {
  std::vector<double> voltages;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.voltages);
    xdr.SingleItems(m.voltages);
  }
  bool operator==(const AioData&) const = default;
};

/// aio CMD STATE.
struct AioCmd {
  std::uint32_t id = 0;
  double voltage = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.id);
    xdr.Single(m.voltage);
  }
  bool operator==(const AioCmd&) const = default;
};

// --- ir

inline constexpr std::uint16_t kIr = 22;

inline constexpr std::uint8_t kIrReqPose = 1;
inline constexpr std::uint8_t kIrReqPower = 2;
inline constexpr std::uint8_t kIrDataRanges = 1;

/// ir DATA RANGES.
struct IrData {
  std::vector<double> voltages;
  std::vector<double> ranges;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.voltages);
    xdr.SingleItems(m.voltages);
    xdr.Count(m.ranges);
    xdr.SingleItems(m.ranges);
  }
  bool operator==(const IrData&) const = default;
};

/// ir REQ POSE.
struct IrPose {
  std::vector<Pose3d> poses;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.poses);
    xdr.Items(m.poses);
  }
  bool operator==(const IrPose&) const = default;
};

/// ir REQ POWER.
struct IrPowerReq {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const IrPowerReq&) const = default;
};

// --- wifi

inline constexpr std::uint16_t kWifi = 23;

inline constexpr std::uint8_t kWifiReqMac = 1;
inline constexpr std::uint8_t kWifiReqIwspyAdd = 2;
inline constexpr std::uint8_t kWifiReqIwspyDel = 3;
inline constexpr std::uint8_t kWifiReqIwspyPing = 4;
inline constexpr std::uint8_t kWifiDataState = 1;

struct WifiLink {
  std::vector<std::uint8_t> mac;
  std::vector<std::uint8_t> ip;
  std::vector<std::uint8_t> essid;
  std::uint32_t mode = 0;
  std::uint32_t freq = 0;
  std::uint32_t encrypt = 0;
  std::uint32_t qual = 0;
  std::uint32_t level = 0;
  std::uint32_t noise = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.mac);
    xdr.Items(m.mac, 32);
    xdr.Count(m.ip);
    xdr.Items(m.ip, 32);
    xdr.Count(m.essid);
    xdr.Items(m.essid, 32);
    xdr.Value(m.mode);
    xdr.Value(m.freq);
    xdr.Value(m.encrypt);
    xdr.Value(m.qual);
    xdr.Value(m.level);
    xdr.Value(m.noise);
  }
  bool operator==(const WifiLink&) const = default;
};

/// wifi DATA STATE.
struct WifiData {
  std::vector<WifiLink> links;
  std::uint32_t throughput = 0;
  std::uint32_t bitrate = 0;
  std::uint32_t mode = 0;
  std::uint32_t qual_type = 0;
  std::uint32_t maxqual = 0;
  std::uint32_t maxlevel = 0;
  std::uint32_t maxnoise = 0;
  std::array<std::uint8_t, 32> ap{};

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.links);
    xdr.Items(m.links);
    xdr.Value(m.throughput);
    xdr.Value(m.bitrate);
    xdr.Value(m.mode);
    xdr.Value(m.qual_type);
    xdr.Value(m.maxqual);
    xdr.Value(m.maxlevel);
    xdr.Value(m.maxnoise);
    xdr.Value(m.ap);
  }
  bool operator==(const WifiData&) const = default;
};

/// wifi REQ MAC.
struct WifiMacReq {
  std::vector<std::uint8_t> mac;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.mac);
    xdr.Items(m.mac, 32);
  }
  bool operator==(const WifiMacReq&) const = default;
};

/// wifi REQ IWSPY_ADD, wifi REQ IWSPY_DEL, wifi REQ IWSPY_PING.
struct WifiIwspyAddrReq {
  std::array<std::uint8_t, 32> address{};

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.address);
  }
  bool operator==(const WifiIwspyAddrReq&) const = default;
};

// --- localize

inline constexpr std::uint16_t kLocalize = 25;

inline constexpr std::uint8_t kLocalizeDataHypoths = 1;
inline constexpr std::uint8_t kLocalizeReqSetPose = 1;
inline constexpr std::uint8_t kLocalizeReqGetParticles = 2;

struct LocalizeHypoth {
  Pose2d mean;
  std::array<double, 6> cov{};
  double alpha = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.mean);
    xdr.Value(m.cov);
    xdr.Value(m.alpha);
  }
  bool operator==(const LocalizeHypoth&) const = default;
};

/// localize DATA HYPOTHS.
struct LocalizeData {
  std::uint32_t pending_count = 0;
  double pending_time = 0;
  std::vector<LocalizeHypoth> hypoths;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pending_count);
    xdr.Value(m.pending_time);
    xdr.Count(m.hypoths);
    xdr.Items(m.hypoths);
  }
  bool operator==(const LocalizeData&) const = default;
};

/// localize REQ SET_POSE.
struct LocalizeSetPose {
  Pose2d mean;
  std::array<double, 6> cov{};

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.mean);
    xdr.Value(m.cov);
  }
  bool operator==(const LocalizeSetPose&) const = default;
};

struct LocalizeParticle {
  Pose2d pose;
  double alpha = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.alpha);
  }
  bool operator==(const LocalizeParticle&) const = default;
};

/// localize REQ GET_PARTICLES.
struct LocalizeGetParticles {
  Pose2d mean;
  double variance = 0;
  std::vector<LocalizeParticle> particles;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.mean);
    xdr.Value(m.variance);
    xdr.Count(m.particles);
    xdr.Items(m.particles);
  }
  bool operator==(const LocalizeGetParticles&) const = default;
};

// --- position3d

inline constexpr std::uint16_t kPosition3d = 30;

inline constexpr std::uint8_t kPosition3dDataState = 1;
inline constexpr std::uint8_t kPosition3dDataGeometry = 2;
inline constexpr std::uint8_t kPosition3dCmdSetVel = 1;
inline constexpr std::uint8_t kPosition3dCmdSetPos = 2;
inline constexpr std::uint8_t kPosition3dReqGetGeom = 1;
inline constexpr std::uint8_t kPosition3dReqMotorPower = 2;
inline constexpr std::uint8_t kPosition3dReqVelocityMode = 3;
inline constexpr std::uint8_t kPosition3dReqPositionMode = 4;
inline constexpr std::uint8_t kPosition3dReqResetOdom = 5;
inline constexpr std::uint8_t kPosition3dReqSetOdom = 6;
inline constexpr std::uint8_t kPosition3dReqSpeedPid = 7;
inline constexpr std::uint8_t kPosition3dReqPositionPid = 8;
inline constexpr std::uint8_t kPosition3dReqSpeedProf = 9;

/// position3d DATA STATE.
struct Position3dData {
  Pose3d pos;
  Pose3d vel;
  std::uint8_t stall = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pos);
    xdr.Value(m.vel);
    xdr.Value(m.stall);
  }
  bool operator==(const Position3dData&) const = default;
};

/// position3d CMD SET_POS.
struct Position3dCmdPos {
  Pose3d pos;
  Pose3d vel;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pos);
    xdr.Value(m.vel);
    xdr.Value(m.state);
  }
  bool operator==(const Position3dCmdPos&) const = default;
};

/// position3d CMD SET_VEL.
struct Position3dCmdVel {
  Pose3d vel;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.vel);
    xdr.Value(m.state);
  }
  bool operator==(const Position3dCmdVel&) const = default;
};

/// position3d DATA GEOMETRY, position3d REQ GET_GEOM.
struct Position3dGeom {
  Pose3d pose;
  Bbox3d size;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.size);
  }
  bool operator==(const Position3dGeom&) const = default;
};

/// position3d REQ MOTOR_POWER.
struct Position3dPowerConfig {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const Position3dPowerConfig&) const = default;
};

/// position3d REQ POSITION_MODE.
struct Position3dPositionModeReq {
  std::uint32_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const Position3dPositionModeReq&) const = default;
};

/// position3d REQ VELOCITY_MODE.
struct Position3dVelocityModeConfig {
  std::uint32_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const Position3dVelocityModeConfig&) const = default;
};

/// position3d REQ SET_ODOM.
struct Position3dSetOdomReq {
  Pose3d pos;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pos);
  }
  bool operator==(const Position3dSetOdomReq&) const = default;
};

/// position3d REQ SPEED_PID.
struct Position3dSpeedPidReq {
  double kp = 0;
  double ki = 0;
  double kd = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.kp);
    xdr.Single(m.ki);
    xdr.Single(m.kd);
  }
  bool operator==(const Position3dSpeedPidReq&) const = default;
};

/// position3d REQ POSITION_PID.
struct Position3dPositionPidReq {
  double kp = 0;
  double ki = 0;
  double kd = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.kp);
    xdr.Single(m.ki);
    xdr.Single(m.kd);
  }
  bool operator==(const Position3dPositionPidReq&) const = default;
};

/// position3d REQ SPEED_PROF.
struct Position3dSpeedProfReq {
  double speed = 0;
  double acc = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.speed);
    xdr.Single(m.acc);
  }
  bool operator==(const Position3dSpeedProfReq&) const = default;
};

// --- simulation

inline constexpr std::uint16_t kSimulation = 31;

inline constexpr std::uint8_t kSimulationReqGetPose2d = 1;
inline constexpr std::uint8_t kSimulationReqSetPose2d = 2;
inline constexpr std::uint8_t kSimulationReqGetPose3d = 3;
inline constexpr std::uint8_t kSimulationReqSetPose3d = 4;
inline constexpr std::uint8_t kSimulationReqGetProperty = 5;
inline constexpr std::uint8_t kSimulationReqSetProperty = 6;
inline constexpr std::uint8_t kSimulationCmdPause = 1;
inline constexpr std::uint8_t kSimulationCmdReset = 2;
inline constexpr std::uint8_t kSimulationCmdSave = 3;

struct SimulationData {
  std::uint8_t data = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.data);
  }
  bool operator==(const SimulationData&) const = default;
};

struct SimulationCmd {
  std::uint8_t cmd = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.cmd);
  }
  bool operator==(const SimulationCmd&) const = default;
};

/// simulation REQ GET_POSE2D, simulation REQ SET_POSE2D.
struct SimulationPose2dReq {
  std::string name;
  Pose2d pose;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.name);
    xdr.Items(m.name);
    xdr.Value(m.pose);
  }
  bool operator==(const SimulationPose2dReq&) const = default;
};

/// simulation REQ GET_POSE3D, simulation REQ SET_POSE3D.
struct SimulationPose3dReq {
  std::string name;
  Pose3d pose;
  double simtime = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.name);
    xdr.Items(m.name);
    xdr.Value(m.pose);
    xdr.Value(m.simtime);
  }
  bool operator==(const SimulationPose3dReq&) const = default;
};

/// simulation REQ GET_PROPERTY, simulation REQ SET_PROPERTY.
struct SimulationPropertyReq {
  std::string name;
  std::string prop;
  std::uint32_t index = 0;
  std::vector<std::uint8_t> value;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.name);
    xdr.Items(m.name);
    xdr.Count(m.prop);
    xdr.Items(m.prop);
    xdr.Value(m.index);
    xdr.Count(m.value);
    xdr.Items(m.value);
  }
  bool operator==(const SimulationPropertyReq&) const = default;
};

// --- blinkenlight

inline constexpr std::uint16_t kBlinkenlight = 33;

inline constexpr std::uint8_t kBlinkenlightDataState = 1;
inline constexpr std::uint8_t kBlinkenlightCmdState = 1;
inline constexpr std::uint8_t kBlinkenlightCmdPower = 2;
inline constexpr std::uint8_t kBlinkenlightCmdColor = 3;
inline constexpr std::uint8_t kBlinkenlightCmdFlash = 4;

/// blinkenlight DATA STATE.
struct BlinkenlightData {
  std::uint8_t enable = 0;
  double period = 0;
  double dutycycle = 0;
  Color color;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.enable);
    xdr.Single(m.period);
    xdr.Single(m.dutycycle);
    xdr.Value(m.color);
  }
  bool operator==(const BlinkenlightData&) const = default;
};

/// blinkenlight CMD STATE.
struct BlinkenlightCmd {
  std::uint16_t id = 0;
  std::uint8_t enable = 0;
  double period = 0;
  double dutycycle = 0;
  Color color;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.id);
    xdr.Value(m.enable);
    xdr.Single(m.period);
    xdr.Single(m.dutycycle);
    xdr.Value(m.color);
  }
  bool operator==(const BlinkenlightCmd&) const = default;
};

/// blinkenlight CMD POWER.
struct BlinkenlightCmdPower {
  std::uint16_t id = 0;
  std::uint8_t enable = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.id);
    xdr.Value(m.enable);
  }
  bool operator==(const BlinkenlightCmdPower&) const = default;
};

/// blinkenlight CMD COLOR.
struct BlinkenlightCmdColor {
  std::uint16_t id = 0;
  Color color;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.id);
    xdr.Value(m.color);
  }
  bool operator==(const BlinkenlightCmdColor&) const = default;
};

/// blinkenlight CMD FLASH.
struct BlinkenlightCmdFlash {
  std::uint16_t id = 0;
  double period = 0;
  double dutycycle = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.id);
    xdr.Single(m.period);
    xdr.Single(m.dutycycle);
  }
  bool operator==(const BlinkenlightCmdFlash&) const = default;
};

// --- camera

inline constexpr std::uint16_t kCamera = 40;

inline constexpr std::uint8_t kCameraDataState = 1;
inline constexpr std::uint8_t kCameraReqGetSource = 1;
inline constexpr std::uint8_t kCameraReqSetSource = 2;
inline constexpr std::uint8_t kCameraReqGetImage = 3;

/// camera DATA STATE, camera REQ GET_IMAGE.
struct CameraData {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t bpp = 0;
  std::uint32_t format = 0;
  std::uint32_t fdiv = 0;
  std::uint32_t compression = 0;
  std::vector<std::uint8_t> image;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.width);
    xdr.Value(m.height);
    xdr.Value(m.bpp);
    xdr.Value(m.format);
    xdr.Value(m.fdiv);
    xdr.Value(m.compression);
    xdr.Count(m.image);
    xdr.Items(m.image);
  }
  bool operator==(const CameraData&) const = default;
};

/// camera REQ GET_SOURCE, camera REQ SET_SOURCE.
struct CameraSource {
  std::string norm;
  std::int32_t source = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.norm);
    xdr.Items(m.norm);
    xdr.Value(m.source);
  }
  bool operator==(const CameraSource&) const = default;
};

// --- map

inline constexpr std::uint16_t kMap = 42;

inline constexpr std::uint8_t kMapDataInfo = 1;
inline constexpr std::uint8_t kMapReqGetInfo = 1;
inline constexpr std::uint8_t kMapReqGetData = 2;
inline constexpr std::uint8_t kMapReqGetVector = 3;

/// map DATA INFO, map REQ GET_INFO.
struct MapInfo {
  double scale = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Pose2d origin;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.scale);
    xdr.Value(m.width);
    xdr.Value(m.height);
    xdr.Value(m.origin);
  }
  bool operator==(const MapInfo&) const = default;
};

/// map REQ GET_DATA.
struct MapData {
  std::uint32_t col = 0;
  std::uint32_t row = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::int8_t data_range = 0;
  std::vector<std::uint8_t> data;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.col);
    xdr.Value(m.row);
    xdr.Value(m.width);
    xdr.Value(m.height);
    xdr.Count(m.data);
    xdr.Value(m.data_range);
    xdr.Items(m.data);
  }
  bool operator==(const MapData&) const = default;
};

/// map REQ GET_VECTOR.
struct MapDataVector {
  double minx = 0;
  double maxx = 0;
  double miny = 0;
  double maxy = 0;
  std::vector<Segment> segments;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.minx);
    xdr.Single(m.maxx);
    xdr.Single(m.miny);
    xdr.Single(m.maxy);
    xdr.Count(m.segments);
    xdr.Items(m.segments);
  }
  bool operator==(const MapDataVector&) const = default;
};

// --- planner

inline constexpr std::uint16_t kPlanner = 44;

inline constexpr std::uint8_t kPlannerDataState = 1;
inline constexpr std::uint8_t kPlannerCmdGoal = 1;
inline constexpr std::uint8_t kPlannerCmdStart = 2;
inline constexpr std::uint8_t kPlannerReqGetWaypoints = 1;
inline constexpr std::uint8_t kPlannerReqEnable = 2;

/// planner DATA STATE.
struct PlannerData {
  std::uint8_t valid = 0;
  std::uint8_t done = 0;
  Pose2d pos;
  Pose2d goal;
  Pose2d waypoint;
  std::int32_t waypoint_idx = 0;
  std::uint32_t waypoints_count = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.valid);
    xdr.Value(m.done);
    xdr.Value(m.pos);
    xdr.Value(m.goal);
    xdr.Value(m.waypoint);
    xdr.Value(m.waypoint_idx);
    xdr.Value(m.waypoints_count);
  }
  bool operator==(const PlannerData&) const = default;
};

/// planner CMD GOAL, planner CMD START.
struct PlannerCmd {
  Pose2d goal;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.goal);
  }
  bool operator==(const PlannerCmd&) const = default;
};

/// planner REQ GET_WAYPOINTS.
struct PlannerWaypointsReq {
  double waypoints_distance = 0;
  std::vector<Pose2d> waypoints;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.waypoints_distance);
    xdr.Count(m.waypoints);
    xdr.Items(m.waypoints);
  }
  bool operator==(const PlannerWaypointsReq&) const = default;
};

/// planner REQ ENABLE.
struct PlannerEnableReq {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const PlannerEnableReq&) const = default;
};

// --- log

inline constexpr std::uint16_t kLog = 45;

inline constexpr std::uint8_t kLogReqSetWriteState = 1;
inline constexpr std::uint8_t kLogReqSetReadState = 2;
inline constexpr std::uint8_t kLogReqGetState = 3;
inline constexpr std::uint8_t kLogReqSetReadRewind = 4;
inline constexpr std::uint8_t kLogReqSetFilename = 5;

/// log REQ SET_WRITE_STATE.
struct LogSetWriteState {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const LogSetWriteState&) const = default;
};

/// log REQ SET_READ_STATE.
struct LogSetReadState {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const LogSetReadState&) const = default;
};

/// log REQ GET_STATE.
struct LogGetState {
  std::uint8_t type = 0;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.type);
    xdr.Value(m.state);
  }
  bool operator==(const LogGetState&) const = default;
};

/// log REQ SET_FILENAME.
struct LogSetFilename {
  std::string filename;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.filename);
    xdr.Items(m.filename, 256);
  }
  bool operator==(const LogSetFilename&) const = default;
};

// --- joystick

inline constexpr std::uint16_t kJoystick = 49;

inline constexpr std::uint8_t kJoystickDataState = 1;

/// joystick DATA STATE.
struct JoystickData {
  std::array<std::int32_t, 8> pos{};
  std::array<std::int32_t, 8> scale{};
  std::uint32_t buttons = 0;
  std::uint32_t axes_count = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pos);
    xdr.Value(m.scale);
    xdr.Value(m.buttons);
    xdr.Value(m.axes_count);
  }
  bool operator==(const JoystickData&) const = default;
};

// --- speech_recognition

inline constexpr std::uint16_t kSpeechRecognition = 50;

inline constexpr std::uint8_t kSpeechRecognitionDataString = 1;

/// speech_recognition DATA STRING.
struct SpeechRecognitionData {
  std::string text;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.text);
    xdr.Items(m.text);
  }
  bool operator==(const SpeechRecognitionData&) const = default;
};

// --- opaque

inline constexpr std::uint16_t kOpaque = 51;

inline constexpr std::uint8_t kOpaqueDataState = 1;
inline constexpr std::uint8_t kOpaqueCmdData = 1;
inline constexpr std::uint8_t kOpaqueReqData = 1;

/// opaque DATA STATE, opaque CMD DATA, opaque REQ DATA.
struct OpaqueData {
  std::vector<std::uint8_t> data;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.data);
    xdr.Items(m.data);
  }
  bool operator==(const OpaqueData&) const = default;
};

// --- position1d

inline constexpr std::uint16_t kPosition1d = 52;

inline constexpr std::uint8_t kPosition1dReqGetGeom = 1;
inline constexpr std::uint8_t kPosition1dReqMotorPower = 2;
inline constexpr std::uint8_t kPosition1dReqVelocityMode = 3;
inline constexpr std::uint8_t kPosition1dReqPositionMode = 4;
inline constexpr std::uint8_t kPosition1dReqSetOdom = 5;
inline constexpr std::uint8_t kPosition1dReqResetOdom = 6;
inline constexpr std::uint8_t kPosition1dReqSpeedPid = 7;
inline constexpr std::uint8_t kPosition1dReqPositionPid = 8;
inline constexpr std::uint8_t kPosition1dReqSpeedProf = 9;
inline constexpr std::uint8_t kPosition1dDataState = 1;
inline constexpr std::uint8_t kPosition1dDataGeom = 2;
inline constexpr std::uint8_t kPosition1dCmdVel = 1;
inline constexpr std::uint8_t kPosition1dCmdPos = 2;

/// position1d DATA STATE.
struct Position1dData {
  double pos = 0;
  double vel = 0;
  std::uint8_t stall = 0;
  std::uint8_t status = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.pos);
    xdr.Single(m.vel);
    xdr.Value(m.stall);
    xdr.Value(m.status);
  }
  bool operator==(const Position1dData&) const = default;
};

/// position1d CMD VEL.
struct Position1dCmdVel {
  double vel = 0;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.vel);
    xdr.Value(m.state);
  }
  bool operator==(const Position1dCmdVel&) const = default;
};

/// position1d CMD POS.
struct Position1dCmdPos {
  double pos = 0;
  double vel = 0;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.pos);
    xdr.Single(m.vel);
    xdr.Value(m.state);
  }
  bool operator==(const Position1dCmdPos&) const = default;
};

/// position1d REQ GET_GEOM, position1d DATA GEOM.
struct Position1dGeom {
  Pose3d pose;
  Bbox3d size;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.size);
  }
  bool operator==(const Position1dGeom&) const = default;
};

/// position1d REQ MOTOR_POWER.
struct Position1dPowerConfig {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const Position1dPowerConfig&) const = default;
};

/// position1d REQ VELOCITY_MODE.
struct Position1dVelocityModeConfig {
  std::uint32_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const Position1dVelocityModeConfig&) const = default;
};

/// position1d REQ RESET_ODOM.
struct Position1dResetOdomConfig {
  std::uint32_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const Position1dResetOdomConfig&) const = default;
};

/// position1d REQ POSITION_MODE.
struct Position1dPositionModeReq {
  std::uint32_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const Position1dPositionModeReq&) const = default;
};

/// position1d REQ SET_ODOM.
struct Position1dSetOdomReq {
  double pos = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.pos);
  }
  bool operator==(const Position1dSetOdomReq&) const = default;
};

/// position1d REQ SPEED_PID.
struct Position1dSpeedPidReq {
  double kp = 0;
  double ki = 0;
  double kd = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.kp);
    xdr.Single(m.ki);
    xdr.Single(m.kd);
  }
  bool operator==(const Position1dSpeedPidReq&) const = default;
};

/// position1d REQ POSITION_PID.
struct Position1dPositionPidReq {
  double kp = 0;
  double ki = 0;
  double kd = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.kp);
    xdr.Single(m.ki);
    xdr.Single(m.kd);
  }
  bool operator==(const Position1dPositionPidReq&) const = default;
};

/// position1d REQ SPEED_PROF.
struct Position1dSpeedProfReq {
  double speed = 0;
  double acc = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.speed);
    xdr.Single(m.acc);
  }
  bool operator==(const Position1dSpeedProfReq&) const = default;
};

// --- actarray

inline constexpr std::uint16_t kActarray = 53;

inline constexpr std::uint8_t kActarrayReqPower = 1;
inline constexpr std::uint8_t kActarrayReqBrakes = 2;
inline constexpr std::uint8_t kActarrayReqGetGeom = 3;
inline constexpr std::uint8_t kActarrayReqSpeed = 4;
inline constexpr std::uint8_t kActarrayReqAccel = 5;
inline constexpr std::uint8_t kActarrayCmdPos = 1;
inline constexpr std::uint8_t kActarrayCmdMultiPos = 2;
inline constexpr std::uint8_t kActarrayCmdSpeed = 3;
inline constexpr std::uint8_t kActarrayCmdMultiSpeed = 4;
inline constexpr std::uint8_t kActarrayCmdHome = 5;
inline constexpr std::uint8_t kActarrayCmdCurrent = 6;
inline constexpr std::uint8_t kActarrayCmdMultiCurrent = 7;
inline constexpr std::uint8_t kActarrayDataState = 1;

struct ActarrayActuator {
  double position = 0;
  double speed = 0;
  double acceleration = 0;
  double current = 0;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.position);
    xdr.Single(m.speed);
    xdr.Single(m.acceleration);
    xdr.Single(m.current);
    xdr.Value(m.state);
  }
  bool operator==(const ActarrayActuator&) const = default;
};

/// actarray DATA STATE.
struct ActarrayData {
  std::vector<ActarrayActuator> actuators;
  std::uint8_t motor_state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.actuators);
    xdr.Items(m.actuators);
    xdr.Value(m.motor_state);
  }
  bool operator==(const ActarrayData&) const = default;
};

struct ActarrayActuatorgeom {
  std::uint8_t type = 0;
  double length = 0;
  Orientation3d orientation;
  Point3d axis;
  double min = 0;
  double centre = 0;
  double max = 0;
  double home = 0;
  double config_speed = 0;
  std::uint8_t hasbrakes = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.type);
    xdr.Single(m.length);
    xdr.Value(m.orientation);
    xdr.Value(m.axis);
    xdr.Single(m.min);
    xdr.Single(m.centre);
    xdr.Single(m.max);
    xdr.Single(m.home);
    xdr.Single(m.config_speed);
    xdr.Value(m.hasbrakes);
  }
  bool operator==(const ActarrayActuatorgeom&) const = default;
};

/// actarray REQ GET_GEOM.
struct ActarrayGeom {
  std::vector<ActarrayActuatorgeom> actuators;
  Point3d base_pos;
  Orientation3d base_orientation;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.actuators);
    xdr.Items(m.actuators);
    xdr.Value(m.base_pos);
    xdr.Value(m.base_orientation);
  }
  bool operator==(const ActarrayGeom&) const = default;
};

/// actarray CMD POS.
struct ActarrayPositionCmd {
  std::int32_t joint = 0;
  double position = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.joint);
    xdr.Single(m.position);
  }
  bool operator==(const ActarrayPositionCmd&) const = default;
};

/// actarray CMD MULTI_POS.
struct ActarrayMultiPositionCmd {
  std::vector<double> positions;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.positions);
    xdr.SingleItems(m.positions);
  }
  bool operator==(const ActarrayMultiPositionCmd&) const = default;
};

/// actarray CMD SPEED.
struct ActarraySpeedCmd {
  std::int32_t joint = 0;
  double speed = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.joint);
    xdr.Single(m.speed);
  }
  bool operator==(const ActarraySpeedCmd&) const = default;
};

/// actarray CMD MULTI_SPEED.
struct ActarrayMultiSpeedCmd {
  std::vector<double> speeds;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.speeds);
    xdr.SingleItems(m.speeds);
  }
  bool operator==(const ActarrayMultiSpeedCmd&) const = default;
};

/// actarray CMD HOME.
struct ActarrayHomeCmd {
  std::int32_t joint = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.joint);
  }
  bool operator==(const ActarrayHomeCmd&) const = default;
};

/// actarray CMD CURRENT.
struct ActarrayCurrentCmd {
  std::int32_t joint = 0;
  double current = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.joint);
    xdr.Single(m.current);
  }
  bool operator==(const ActarrayCurrentCmd&) const = default;
};

/// actarray CMD MULTI_CURRENT.
struct ActarrayMultiCurrentCmd {
  std::vector<double> currents;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.currents);
    xdr.SingleItems(m.currents);
  }
  bool operator==(const ActarrayMultiCurrentCmd&) const = default;
};

/// actarray REQ POWER.
struct ActarrayPowerConfig {
  std::uint8_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const ActarrayPowerConfig&) const = default;
};

/// actarray REQ BRAKES.
struct ActarrayBrakesConfig {
  std::uint8_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const ActarrayBrakesConfig&) const = default;
};

/// actarray REQ SPEED.
struct ActarraySpeedConfig {
  std::int32_t joint = 0;
  double speed = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.joint);
    xdr.Single(m.speed);
  }
  bool operator==(const ActarraySpeedConfig&) const = default;
};

/// actarray REQ ACCEL.
struct ActarrayAccelConfig {
  std::int32_t joint = 0;
  double accel = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.joint);
    xdr.Single(m.accel);
  }
  bool operator==(const ActarrayAccelConfig&) const = default;
};

// --- limb

inline constexpr std::uint16_t kLimb = 54;

inline constexpr std::uint8_t kLimbDataState = 1;
inline constexpr std::uint8_t kLimbCmdHome = 1;
inline constexpr std::uint8_t kLimbCmdStop = 2;
inline constexpr std::uint8_t kLimbCmdSetpose = 3;
inline constexpr std::uint8_t kLimbCmdSetposition = 4;
inline constexpr std::uint8_t kLimbCmdVecmove = 5;
inline constexpr std::uint8_t kLimbReqPower = 1;
inline constexpr std::uint8_t kLimbReqBrakes = 2;
inline constexpr std::uint8_t kLimbReqGeom = 3;
inline constexpr std::uint8_t kLimbReqSpeed = 4;

/// limb DATA STATE.
struct LimbData {
  Point3d position;
  Point3d approach;
  Point3d orientation;
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.position);
    xdr.Value(m.approach);
    xdr.Value(m.orientation);
    xdr.Value(m.state);
  }
  bool operator==(const LimbData&) const = default;
};

/// limb CMD SETPOSE.
struct LimbSetposeCmd {
  Point3d position;
  Point3d approach;
  Point3d orientation;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.position);
    xdr.Value(m.approach);
    xdr.Value(m.orientation);
  }
  bool operator==(const LimbSetposeCmd&) const = default;
};

/// limb CMD SETPOSITION.
struct LimbSetpositionCmd {
  Point3d position;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.position);
  }
  bool operator==(const LimbSetpositionCmd&) const = default;
};

/// limb CMD VECMOVE.
struct LimbVecmoveCmd {
  Point3d direction;
  double length = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.direction);
    xdr.Single(m.length);
  }
  bool operator==(const LimbVecmoveCmd&) const = default;
};

/// limb REQ POWER.
struct LimbPowerReq {
  std::uint8_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const LimbPowerReq&) const = default;
};

/// limb REQ BRAKES.
struct LimbBrakesReq {
  std::uint8_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const LimbBrakesReq&) const = default;
};

/// limb REQ GEOM.
struct LimbGeomReq {
  Point3d basePos;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.basePos);
  }
  bool operator==(const LimbGeomReq&) const = default;
};

/// limb REQ SPEED.
struct LimbSpeedReq {
  double speed = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.speed);
  }
  bool operator==(const LimbSpeedReq&) const = default;
};

// --- graphics2d

inline constexpr std::uint16_t kGraphics2d = 55;

inline constexpr std::uint8_t kGraphics2dCmdClear = 1;
inline constexpr std::uint8_t kGraphics2dCmdPoints = 2;
inline constexpr std::uint8_t kGraphics2dCmdPolyline = 3;
inline constexpr std::uint8_t kGraphics2dCmdPolygon = 4;
inline constexpr std::uint8_t kGraphics2dCmdMultiline = 5;

/// graphics2d CMD POINTS.
struct Graphics2dCmdPoints {
  std::vector<Point2d> points;
  Color color;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.points);
    xdr.Items(m.points);
    xdr.Value(m.color);
  }
  bool operator==(const Graphics2dCmdPoints&) const = default;
};

/// graphics2d CMD POLYLINE.
struct Graphics2dCmdPolyline {
  std::vector<Point2d> points;
  Color color;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.points);
    xdr.Items(m.points);
    xdr.Value(m.color);
  }
  bool operator==(const Graphics2dCmdPolyline&) const = default;
};

/// graphics2d CMD POLYGON.
struct Graphics2dCmdPolygon {
  std::vector<Point2d> points;
  Color color;
  Color fill_color;
  std::uint8_t filled = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.points);
    xdr.Items(m.points);
    xdr.Value(m.color);
    xdr.Value(m.fill_color);
    xdr.Value(m.filled);
  }
  bool operator==(const Graphics2dCmdPolygon&) const = default;
};

/// graphics2d CMD MULTILINE.
struct Graphics2dCmdMultiline {
  std::vector<Point2d> points;
  Color color;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.points);
    xdr.Items(m.points);
    xdr.Value(m.color);
  }
  bool operator==(const Graphics2dCmdMultiline&) const = default;
};

// --- rfid

inline constexpr std::uint16_t kRfid = 56;

inline constexpr std::uint8_t kRfidDataTags = 1;
inline constexpr std::uint8_t kRfidReqPower = 1;
inline constexpr std::uint8_t kRfidReqReadtag = 2;
inline constexpr std::uint8_t kRfidReqWritetag = 3;
inline constexpr std::uint8_t kRfidReqLocktag = 4;

struct RfidTag {
  std::uint32_t type = 0;
  std::vector<std::uint8_t> guid;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.type);
    xdr.Count(m.guid);
    xdr.Items(m.guid);
  }
  bool operator==(const RfidTag&) const = default;
};

/// rfid DATA TAGS.
struct RfidData {
  std::vector<RfidTag> tags;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.tags);
    xdr.Items(m.tags);
  }
  bool operator==(const RfidData&) const = default;
};

// --- wsn

inline constexpr std::uint16_t kWsn = 57;

inline constexpr std::uint8_t kWsnDataState = 1;
inline constexpr std::uint8_t kWsnCmdDevstate = 1;
inline constexpr std::uint8_t kWsnReqPower = 1;
inline constexpr std::uint8_t kWsnReqDatatype = 2;
inline constexpr std::uint8_t kWsnReqDatafreq = 3;

struct WsnNodeData {
  double light = 0;
  double mic = 0;
  double accel_x = 0;
  double accel_y = 0;
  double accel_z = 0;
  double magn_x = 0;
  double magn_y = 0;
  double magn_z = 0;
  double temperature = 0;
  double battery = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.light);
    xdr.Single(m.mic);
    xdr.Single(m.accel_x);
    xdr.Single(m.accel_y);
    xdr.Single(m.accel_z);
    xdr.Single(m.magn_x);
    xdr.Single(m.magn_y);
    xdr.Single(m.magn_z);
    xdr.Single(m.temperature);
    xdr.Single(m.battery);
  }
  bool operator==(const WsnNodeData&) const = default;
};

/// wsn DATA STATE.
struct WsnData {
  std::uint32_t node_type = 0;
  std::uint32_t node_id = 0;
  std::uint32_t node_parent_id = 0;
  WsnNodeData data_packet;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.node_type);
    xdr.Value(m.node_id);
    xdr.Value(m.node_parent_id);
    xdr.Value(m.data_packet);
  }
  bool operator==(const WsnData&) const = default;
};

/// wsn CMD DEVSTATE.
struct WsnCmd {
  std::int32_t node_id = 0;
  std::int32_t group_id = 0;
  std::uint32_t device = 0;
  std::uint8_t enable = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.node_id);
    xdr.Value(m.group_id);
    xdr.Value(m.device);
    xdr.Value(m.enable);
  }
  bool operator==(const WsnCmd&) const = default;
};

/// wsn REQ POWER.
struct WsnPowerConfig {
  std::int32_t node_id = 0;
  std::int32_t group_id = 0;
  std::uint8_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.node_id);
    xdr.Value(m.group_id);
    xdr.Value(m.value);
  }
  bool operator==(const WsnPowerConfig&) const = default;
};

/// wsn REQ DATATYPE.
struct WsnDatatypeConfig {
  std::uint8_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const WsnDatatypeConfig&) const = default;
};

/// wsn REQ DATAFREQ.
struct WsnDatafreqConfig {
  std::int32_t node_id = 0;
  std::int32_t group_id = 0;
  double frequency = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.node_id);
    xdr.Value(m.group_id);
    xdr.Value(m.frequency);
  }
  bool operator==(const WsnDatafreqConfig&) const = default;
};

// --- graphics3d

inline constexpr std::uint16_t kGraphics3d = 58;

inline constexpr std::uint8_t kGraphics3dCmdClear = 1;
inline constexpr std::uint8_t kGraphics3dCmdDraw = 2;
inline constexpr std::uint8_t kGraphics3dCmdTranslate = 3;
inline constexpr std::uint8_t kGraphics3dCmdRotate = 4;
inline constexpr std::uint8_t kGraphics3dCmdPush = 5;
inline constexpr std::uint8_t kGraphics3dCmdPop = 6;

/// graphics3d CMD DRAW.
struct Graphics3dCmdDraw {
  std::uint32_t draw_mode = 0;
  std::vector<Point3d> points;
  Color color;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.draw_mode);
    xdr.Count(m.points);
    xdr.Items(m.points);
    xdr.Value(m.color);
  }
  bool operator==(const Graphics3dCmdDraw&) const = default;
};

/// graphics3d CMD TRANSLATE.
struct Graphics3dCmdTranslate {
  double x = 0;
  double y = 0;
  double z = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.x);
    xdr.Value(m.y);
    xdr.Value(m.z);
  }
  bool operator==(const Graphics3dCmdTranslate&) const = default;
};

/// graphics3d CMD ROTATE.
struct Graphics3dCmdRotate {
  double a = 0;
  double x = 0;
  double y = 0;
  double z = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.a);
    xdr.Value(m.x);
    xdr.Value(m.y);
    xdr.Value(m.z);
  }
  bool operator==(const Graphics3dCmdRotate&) const = default;
};

// --- health

inline constexpr std::uint16_t kHealth = 59;

inline constexpr std::uint8_t kHealthDataState = 1;

struct HealthCpu {
  double idle = 0;
  double system = 0;
  double user = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.idle);
    xdr.Single(m.system);
    xdr.Single(m.user);
  }
  bool operator==(const HealthCpu&) const = default;
};

struct HealthMemory {
  std::int64_t total = 0;
  std::int64_t used = 0;
  std::int64_t free = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.total);
    xdr.Value(m.used);
    xdr.Value(m.free);
  }
  bool operator==(const HealthMemory&) const = default;
};

/// health DATA STATE.
struct HealthData {
  HealthCpu cpu_usage;
  HealthMemory mem;
  HealthMemory swap;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.cpu_usage);
    xdr.Value(m.mem);
    xdr.Value(m.swap);
  }
  bool operator==(const HealthData&) const = default;
};

// --- imu

inline constexpr std::uint16_t kImu = 60;

inline constexpr std::uint8_t kImuDataState = 1;
inline constexpr std::uint8_t kImuDataCalib = 2;
inline constexpr std::uint8_t kImuDataQuat = 3;
inline constexpr std::uint8_t kImuDataEuler = 4;
inline constexpr std::uint8_t kImuDataFullstate = 5;
inline constexpr std::uint8_t kImuReqSetDatatype = 1;
inline constexpr std::uint8_t kImuReqResetOrientation = 2;
inline constexpr std::uint8_t kImuReqResetEuler = 3;

/// imu DATA STATE.
struct ImuDataState {
  Pose3d pose;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
  }
  bool operator==(const ImuDataState&) const = default;
};

/// imu DATA CALIB.
struct ImuDataCalib {
  double accel_x = 0;
  double accel_y = 0;
  double accel_z = 0;
  double gyro_x = 0;
  double gyro_y = 0;
  double gyro_z = 0;
  double magn_x = 0;
  double magn_y = 0;
  double magn_z = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.accel_x);
    xdr.Single(m.accel_y);
    xdr.Single(m.accel_z);
    xdr.Single(m.gyro_x);
    xdr.Single(m.gyro_y);
    xdr.Single(m.gyro_z);
    xdr.Single(m.magn_x);
    xdr.Single(m.magn_y);
    xdr.Single(m.magn_z);
  }
  bool operator==(const ImuDataCalib&) const = default;
};

/// imu DATA QUAT.
struct ImuDataQuat {
  ImuDataCalib calib_data;
  double q0 = 0;
  double q1 = 0;
  double q2 = 0;
  double q3 = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.calib_data);
    xdr.Single(m.q0);
    xdr.Single(m.q1);
    xdr.Single(m.q2);
    xdr.Single(m.q3);
  }
  bool operator==(const ImuDataQuat&) const = default;
};

/// imu DATA EULER.
struct ImuDataEuler {
  ImuDataCalib calib_data;
  Orientation3d orientation;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.calib_data);
    xdr.Value(m.orientation);
  }
  bool operator==(const ImuDataEuler&) const = default;
};

/// imu DATA FULLSTATE.
struct ImuDataFullstate {
  Pose3d pose;
  Pose3d vel;
  Pose3d acc;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.vel);
    xdr.Value(m.acc);
  }
  bool operator==(const ImuDataFullstate&) const = default;
};

/// imu REQ SET_DATATYPE.
struct ImuDatatypeConfig {
  std::uint8_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const ImuDatatypeConfig&) const = default;
};

/// imu REQ RESET_ORIENTATION.
struct ImuResetOrientationConfig {
  std::uint32_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.value);
  }
  bool operator==(const ImuResetOrientationConfig&) const = default;
};

/// imu REQ RESET_EULER.
struct ImuResetEulerConfig {
  Pose3d orientation;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.orientation);
  }
  bool operator==(const ImuResetEulerConfig&) const = default;
};

// --- pointcloud3d

inline constexpr std::uint16_t kPointcloud3d = 61;

inline constexpr std::uint8_t kPointcloud3dDataState = 1;

struct Pointcloud3dElement {
  Point3d point;
  Color color;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.point);
    xdr.Value(m.color);
  }
  bool operator==(const Pointcloud3dElement&) const = default;
};

/// pointcloud3d DATA STATE.
struct Pointcloud3dData {
  std::vector<Pointcloud3dElement> points;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.points);
    xdr.Items(m.points);
  }
  bool operator==(const Pointcloud3dData&) const = default;
};

// --- ranger

inline constexpr std::uint16_t kRanger = 62;

inline constexpr std::uint8_t kRangerDataRange = 1;
inline constexpr std::uint8_t kRangerDataRangestamped = 2;
inline constexpr std::uint8_t kRangerDataIntns = 3;
inline constexpr std::uint8_t kRangerDataIntnsstamped = 4;
inline constexpr std::uint8_t kRangerDataGeom = 5;
inline constexpr std::uint8_t kRangerReqGetGeom = 1;
inline constexpr std::uint8_t kRangerReqPower = 2;
inline constexpr std::uint8_t kRangerReqIntns = 3;
inline constexpr std::uint8_t kRangerReqSetConfig = 4;
inline constexpr std::uint8_t kRangerReqGetConfig = 5;

/// ranger REQ SET_CONFIG, ranger REQ GET_CONFIG.
struct RangerConfig {
  double min_angle = 0;
  double max_angle = 0;
  double angular_res = 0;
  double min_range = 0;
  double max_range = 0;
  double range_res = 0;
  double frequency = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.min_angle);
    xdr.Value(m.max_angle);
    xdr.Value(m.angular_res);
    xdr.Value(m.min_range);
    xdr.Value(m.max_range);
    xdr.Value(m.range_res);
    xdr.Value(m.frequency);
  }
  bool operator==(const RangerConfig&) const = default;
};

/// ranger DATA GEOM, ranger REQ GET_GEOM.
struct RangerGeom {
  Pose3d pose;
  Bbox3d size;
  std::vector<Pose3d> element_poses;
  std::vector<Bbox3d> element_sizes;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.pose);
    xdr.Value(m.size);
    xdr.Count(m.element_poses);
    xdr.Items(m.element_poses);
    xdr.Count(m.element_sizes);
    xdr.Items(m.element_sizes);
  }
  bool operator==(const RangerGeom&) const = default;
};

/// ranger DATA RANGE.
struct RangerDataRange {
  std::vector<double> ranges;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.ranges);
    xdr.Items(m.ranges);
  }
  bool operator==(const RangerDataRange&) const = default;
};

/// ranger DATA RANGESTAMPED.
struct RangerDataRangestamped {
  RangerDataRange data;
  std::uint8_t have_geom = 0;
  RangerGeom geom;
  std::uint8_t have_config = 0;
  RangerConfig config;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.data);
    xdr.Value(m.have_geom);
    xdr.Value(m.geom);
    xdr.Value(m.have_config);
    xdr.Value(m.config);
  }
  bool operator==(const RangerDataRangestamped&) const = default;
};

/// ranger DATA INTNS.
struct RangerDataIntns {
  std::vector<double> intensities;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.intensities);
    xdr.Items(m.intensities);
  }
  bool operator==(const RangerDataIntns&) const = default;
};

/// ranger DATA INTNSSTAMPED.
struct RangerDataIntnsstamped {
  RangerDataIntns data;
  std::uint8_t have_geom = 0;
  RangerGeom geom;
  std::uint8_t have_config = 0;
  RangerConfig config;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.data);
    xdr.Value(m.have_geom);
    xdr.Value(m.geom);
    xdr.Value(m.have_config);
    xdr.Value(m.config);
  }
  bool operator==(const RangerDataIntnsstamped&) const = default;
};

/// ranger REQ POWER.
struct RangerPowerConfig {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const RangerPowerConfig&) const = default;
};

/// ranger REQ INTNS.
struct RangerIntnsConfig {
  std::uint8_t state = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.state);
  }
  bool operator==(const RangerIntnsConfig&) const = default;
};

// --- vectormap

inline constexpr std::uint16_t kVectormap = 63;

inline constexpr std::uint8_t kVectormapReqGetMapInfo = 1;
inline constexpr std::uint8_t kVectormapReqGetLayerData = 3;
inline constexpr std::uint8_t kVectormapReqWriteLayer = 4;

struct VectormapFeatureData {
  std::string name;
  std::vector<std::uint8_t> wkb;
  std::string attrib;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.name);
    xdr.Items(m.name);
    xdr.Count(m.wkb);
    xdr.Items(m.wkb);
    xdr.Count(m.attrib);
    xdr.Items(m.attrib);
  }
  bool operator==(const VectormapFeatureData&) const = default;
};

struct VectormapLayerInfo {
  std::string name;
  Extent2d extent;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.name);
    xdr.Items(m.name);
    xdr.Value(m.extent);
  }
  bool operator==(const VectormapLayerInfo&) const = default;
};

/// vectormap REQ GET_LAYER_DATA, vectormap REQ WRITE_LAYER.
struct VectormapLayerData {
  std::string name;
  std::vector<VectormapFeatureData> features;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Count(m.name);
    xdr.Items(m.name);
    xdr.Count(m.features);
    xdr.Items(m.features);
  }
  bool operator==(const VectormapLayerData&) const = default;
};

/// vectormap REQ GET_MAP_INFO.
struct VectormapInfo {
  std::uint32_t srid = 0;
  std::vector<VectormapLayerInfo> layers;
  Extent2d extent;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.srid);
    xdr.Count(m.layers);
    xdr.Items(m.layers);
    xdr.Value(m.extent);
  }
  bool operator==(const VectormapInfo&) const = default;
};

// --- blackboard

inline constexpr std::uint16_t kBlackboard = 64;

inline constexpr std::uint8_t kBlackboardReqSubscribeToKey = 1;
inline constexpr std::uint8_t kBlackboardReqUnsubscribeFromKey = 2;
inline constexpr std::uint8_t kBlackboardReqSetEntry = 3;
inline constexpr std::uint8_t kBlackboardReqSubscribeToGroup = 4;
inline constexpr std::uint8_t kBlackboardReqUnsubscribeFromGroup = 5;
inline constexpr std::uint8_t kBlackboardReqGetEntry = 6;
inline constexpr std::uint8_t kBlackboardDataUpdate = 1;

/// blackboard REQ SUBSCRIBE_TO_KEY, blackboard REQ UNSUBSCRIBE_FROM_KEY, blackboard REQ SET_ENTRY,
/// blackboard REQ SUBSCRIBE_TO_GROUP, blackboard REQ UNSUBSCRIBE_FROM_GROUP, blackboard REQ
/// GET_ENTRY, blackboard DATA UPDATE.
struct BlackboardEntry {
  std::uint16_t type = 0;
  std::uint16_t subtype = 0;
  std::string key;
  std::string group;
  std::vector<std::uint8_t> data;
  std::uint32_t timestamp_sec = 0;
  std::uint32_t timestamp_usec = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.type);
    xdr.Value(m.subtype);
    xdr.Count(m.key);
    xdr.Items(m.key);
    xdr.Count(m.group);
    xdr.Items(m.group);
    xdr.Count(m.data);
    xdr.Items(m.data);
    xdr.Value(m.timestamp_sec);
    xdr.Value(m.timestamp_usec);
  }
  bool operator==(const BlackboardEntry&) const = default;
};

// --- stereo

inline constexpr std::uint16_t kStereo = 65;

inline constexpr std::uint8_t kStereoDataState = 1;

struct Pointcloud3dStereoElement {
  double px = 0;
  double py = 0;
  double pz = 0;
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Single(m.px);
    xdr.Single(m.py);
    xdr.Single(m.pz);
    xdr.Value(m.red);
    xdr.Value(m.green);
    xdr.Value(m.blue);
  }
  bool operator==(const Pointcloud3dStereoElement&) const = default;
};

/// stereo DATA STATE.
struct StereoData {
  CameraData left_channel;
  CameraData right_channel;
  CameraData disparity;
  std::vector<Pointcloud3dStereoElement> points;
  std::uint32_t mode = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.left_channel);
    xdr.Value(m.right_channel);
    xdr.Value(m.disparity);
    xdr.Count(m.points);
    xdr.Items(m.points);
    xdr.Value(m.mode);
  }
  bool operator==(const StereoData&) const = default;
};

// --- coopobject

inline constexpr std::uint16_t kCoopobject = 66;

inline constexpr std::uint8_t kCoopobjectDataHealth = 1;
inline constexpr std::uint8_t kCoopobjectDataRssi = 2;
inline constexpr std::uint8_t kCoopobjectDataSensor = 3;
inline constexpr std::uint8_t kCoopobjectDataAlarm = 4;
inline constexpr std::uint8_t kCoopobjectDataUserdefined = 5;
inline constexpr std::uint8_t kCoopobjectDataRequest = 6;
inline constexpr std::uint8_t kCoopobjectDataCommand = 7;
inline constexpr std::uint8_t kCoopobjectDataPosition = 8;
inline constexpr std::uint8_t kCoopobjectCmdStandard = 1;
inline constexpr std::uint8_t kCoopobjectCmdData = 2;
inline constexpr std::uint8_t kCoopobjectCmdPosition = 3;
inline constexpr std::uint8_t kCoopobjectReqStandard = 1;

/// coopobject DATA HEALTH.
struct CoopobjectHeader {
  std::uint8_t origin = 0;
  std::uint16_t id = 0;
  std::uint16_t parent_id = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.origin);
    xdr.Value(m.id);
    xdr.Value(m.parent_id);
  }
  bool operator==(const CoopobjectHeader&) const = default;
};

/// coopobject DATA RSSI.
struct CoopobjectRssi {
  CoopobjectHeader header;
  std::uint16_t sender_id = 0;
  std::uint16_t rssi = 0;
  std::uint16_t stamp = 0;
  std::uint32_t nodeTimeHigh = 0;
  std::uint32_t nodeTimeLow = 0;
  double x = 0;
  double y = 0;
  double z = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.header);
    xdr.Value(m.sender_id);
    xdr.Value(m.rssi);
    xdr.Value(m.stamp);
    xdr.Value(m.nodeTimeHigh);
    xdr.Value(m.nodeTimeLow);
    xdr.Single(m.x);
    xdr.Single(m.y);
    xdr.Single(m.z);
  }
  bool operator==(const CoopobjectRssi&) const = default;
};

/// coopobject DATA POSITION, coopobject CMD POSITION.
struct CoopobjectPosition {
  CoopobjectHeader header;
  double x = 0;
  double y = 0;
  double z = 0;
  std::uint8_t status = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.header);
    xdr.Single(m.x);
    xdr.Single(m.y);
    xdr.Single(m.z);
    xdr.Value(m.status);
  }
  bool operator==(const CoopobjectPosition&) const = default;
};

struct CoopobjectSensor {
  std::uint8_t type = 0;
  std::int16_t value = 0;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.type);
    xdr.Value(m.value);
  }
  bool operator==(const CoopobjectSensor&) const = default;
};

/// coopobject DATA SENSOR, coopobject DATA ALARM.
struct CoopobjectDataSensor {
  CoopobjectHeader header;
  std::vector<CoopobjectSensor> data;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.header);
    xdr.Count(m.data);
    xdr.Items(m.data);
  }
  bool operator==(const CoopobjectDataSensor&) const = default;
};

/// coopobject DATA USERDEFINED, coopobject CMD DATA.
struct CoopobjectDataUserdefined {
  CoopobjectHeader header;
  std::uint8_t type = 0;
  std::vector<std::uint8_t> data;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.header);
    xdr.Value(m.type);
    xdr.Count(m.data);
    xdr.Items(m.data);
  }
  bool operator==(const CoopobjectDataUserdefined&) const = default;
};

/// coopobject DATA REQUEST, coopobject REQ STANDARD.
struct CoopobjectReq {
  CoopobjectHeader header;
  std::uint8_t request = 0;
  std::vector<std::uint8_t> parameters;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.header);
    xdr.Value(m.request);
    xdr.Count(m.parameters);
    xdr.Items(m.parameters);
  }
  bool operator==(const CoopobjectReq&) const = default;
};

/// coopobject DATA COMMAND, coopobject CMD STANDARD.
struct CoopobjectCmd {
  CoopobjectHeader header;
  std::uint8_t command = 0;
  std::vector<std::uint8_t> parameters;

  template <typename Self, typename Xdr>
  static void Fields(Self& m, Xdr& xdr) {
    xdr.Value(m.header);
    xdr.Value(m.command);
    xdr.Count(m.parameters);
    xdr.Items(m.parameters);
  }
  bool operator==(const CoopobjectCmd&) const = default;
};

// NOLINTEND(readability-identifier-naming,readability-magic-numbers)

/// PLAYER_MESSAGE(interface, code, type, subtype, name, body) for each message that has a body;
/// PLAYER_INTERFACE(name, code) for each interface.
// NOLINTBEGIN(cppcoreguidelines-macro-usage): lists for tables
#define CCMORSE_PLAYER_MESSAGES                                                     \
  PLAYER_MESSAGE(player, 1, 3, 1, DEVLIST, DeviceDevlist)                           \
  PLAYER_MESSAGE(player, 1, 3, 2, DRIVERINFO, DeviceDriverinfo)                     \
  PLAYER_MESSAGE(player, 1, 3, 3, DEV, DeviceReq)                                   \
  PLAYER_MESSAGE(player, 1, 3, 5, DATAMODE, DeviceDatamodeReq)                      \
  PLAYER_MESSAGE(player, 1, 3, 7, AUTH, DeviceAuthReq)                              \
  PLAYER_MESSAGE(player, 1, 3, 8, NAMESERVICE, DeviceNameserviceReq)                \
  PLAYER_MESSAGE(player, 1, 3, 10, ADD_REPLACE_RULE, AddReplaceRuleReq)             \
  PLAYER_MESSAGE(player, 1, 5, 2, OVERFLOW, Overflow)                               \
  PLAYER_MESSAGE(power, 2, 1, 1, STATE, PowerData)                                  \
  PLAYER_MESSAGE(power, 2, 3, 1, SET_CHARGING_POLICY, PowerChargepolicyConfig)      \
  PLAYER_MESSAGE(gripper, 3, 1, 1, STATE, GripperData)                              \
  PLAYER_MESSAGE(gripper, 3, 3, 1, GET_GEOM, GripperGeom)                           \
  PLAYER_MESSAGE(position2d, 4, 3, 1, GET_GEOM, Position2dGeom)                     \
  PLAYER_MESSAGE(position2d, 4, 3, 2, MOTOR_POWER, Position2dPowerConfig)           \
  PLAYER_MESSAGE(position2d, 4, 3, 3, VELOCITY_MODE, Position2dVelocityModeConfig)  \
  PLAYER_MESSAGE(position2d, 4, 3, 4, POSITION_MODE, Position2dPositionModeReq)     \
  PLAYER_MESSAGE(position2d, 4, 3, 5, SET_ODOM, Position2dSetOdomReq)               \
  PLAYER_MESSAGE(position2d, 4, 3, 7, SPEED_PID, Position2dSpeedPidReq)             \
  PLAYER_MESSAGE(position2d, 4, 3, 8, POSITION_PID, Position2dPositionPidReq)       \
  PLAYER_MESSAGE(position2d, 4, 3, 9, SPEED_PROF, Position2dSpeedProfReq)           \
  PLAYER_MESSAGE(position2d, 4, 1, 1, STATE, Position2dData)                        \
  PLAYER_MESSAGE(position2d, 4, 1, 2, GEOM, Position2dGeom)                         \
  PLAYER_MESSAGE(position2d, 4, 2, 1, VEL, Position2dCmdVel)                        \
  PLAYER_MESSAGE(position2d, 4, 2, 2, POS, Position2dCmdPos)                        \
  PLAYER_MESSAGE(position2d, 4, 2, 3, CAR, Position2dCmdCar)                        \
  PLAYER_MESSAGE(position2d, 4, 2, 4, VEL_HEAD, Position2dCmdVelHead)               \
  PLAYER_MESSAGE(sonar, 5, 3, 1, GET_GEOM, SonarGeom)                               \
  PLAYER_MESSAGE(sonar, 5, 3, 2, POWER, SonarPowerConfig)                           \
  PLAYER_MESSAGE(sonar, 5, 1, 1, RANGES, SonarData)                                 \
  PLAYER_MESSAGE(sonar, 5, 1, 2, GEOM, SonarGeom)                                   \
  PLAYER_MESSAGE(laser, 6, 1, 1, SCAN, LaserData)                                   \
  PLAYER_MESSAGE(laser, 6, 1, 2, SCANPOSE, LaserDataScanpose)                       \
  PLAYER_MESSAGE(laser, 6, 1, 3, SCANANGLE, LaserDataScanangle)                     \
  PLAYER_MESSAGE(laser, 6, 3, 1, GET_GEOM, LaserGeom)                               \
  PLAYER_MESSAGE(laser, 6, 3, 2, SET_CONFIG, LaserConfig)                           \
  PLAYER_MESSAGE(laser, 6, 3, 3, GET_CONFIG, LaserConfig)                           \
  PLAYER_MESSAGE(laser, 6, 3, 4, POWER, LaserPowerConfig)                           \
  PLAYER_MESSAGE(laser, 6, 3, 5, GET_ID, LaserGetIdConfig)                          \
  PLAYER_MESSAGE(laser, 6, 3, 6, SET_FILTER, LaserSetFilterConfig)                  \
  PLAYER_MESSAGE(blobfinder, 7, 1, 1, BLOBS, BlobfinderData)                        \
  PLAYER_MESSAGE(blobfinder, 7, 3, 1, SET_COLOR, BlobfinderColorConfig)             \
  PLAYER_MESSAGE(blobfinder, 7, 3, 2, SET_IMAGER_PARAMS, BlobfinderImagerConfig)    \
  PLAYER_MESSAGE(blobfinder, 7, 3, 3, GET_COLOR, BlobfinderColorConfig)             \
  PLAYER_MESSAGE(ptz, 8, 3, 1, GENERIC, PtzReqGeneric)                              \
  PLAYER_MESSAGE(ptz, 8, 3, 2, CONTROL_MODE, PtzReqControlMode)                     \
  PLAYER_MESSAGE(ptz, 8, 3, 4, GEOM, PtzGeom)                                       \
  PLAYER_MESSAGE(ptz, 8, 3, 5, STATUS, PtzReqStatus)                                \
  PLAYER_MESSAGE(ptz, 8, 1, 1, STATE, PtzData)                                      \
  PLAYER_MESSAGE(ptz, 8, 1, 2, GEOM, PtzGeom)                                       \
  PLAYER_MESSAGE(ptz, 8, 2, 1, STATE, PtzCmd)                                       \
  PLAYER_MESSAGE(audio, 9, 1, 1, WAV_REC, AudioWav)                                 \
  PLAYER_MESSAGE(audio, 9, 1, 2, SEQ, AudioSeq)                                     \
  PLAYER_MESSAGE(audio, 9, 1, 3, MIXER_CHANNEL, AudioMixerChannelList)              \
  PLAYER_MESSAGE(audio, 9, 1, 4, STATE, AudioState)                                 \
  PLAYER_MESSAGE(audio, 9, 2, 1, WAV_PLAY, AudioWav)                                \
  PLAYER_MESSAGE(audio, 9, 2, 2, WAV_STREAM_REC, Bool)                              \
  PLAYER_MESSAGE(audio, 9, 2, 3, SAMPLE_PLAY, AudioSampleItem)                      \
  PLAYER_MESSAGE(audio, 9, 2, 4, SEQ_PLAY, AudioSeq)                                \
  PLAYER_MESSAGE(audio, 9, 2, 5, MIXER_CHANNEL, AudioMixerChannelList)              \
  PLAYER_MESSAGE(audio, 9, 3, 1, WAV_REC, AudioWav)                                 \
  PLAYER_MESSAGE(audio, 9, 3, 2, SAMPLE_LOAD, AudioSample)                          \
  PLAYER_MESSAGE(audio, 9, 3, 3, SAMPLE_RETRIEVE, AudioSample)                      \
  PLAYER_MESSAGE(audio, 9, 3, 4, SAMPLE_REC, AudioSampleItem)                       \
  PLAYER_MESSAGE(audio, 9, 3, 5, MIXER_CHANNEL_LIST, AudioMixerChannelListDetail)   \
  PLAYER_MESSAGE(audio, 9, 3, 6, MIXER_CHANNEL_LEVEL, AudioMixerChannelList)        \
  PLAYER_MESSAGE(fiducial, 10, 1, 1, SCAN, FiducialData)                            \
  PLAYER_MESSAGE(fiducial, 10, 3, 1, GET_GEOM, FiducialGeom)                        \
  PLAYER_MESSAGE(fiducial, 10, 3, 2, GET_FOV, FiducialFov)                          \
  PLAYER_MESSAGE(fiducial, 10, 3, 3, SET_FOV, FiducialFov)                          \
  PLAYER_MESSAGE(fiducial, 10, 3, 7, GET_ID, FiducialId)                            \
  PLAYER_MESSAGE(fiducial, 10, 3, 8, SET_ID, FiducialId)                            \
  PLAYER_MESSAGE(speech, 12, 2, 1, SAY, SpeechCmd)                                  \
  PLAYER_MESSAGE(gps, 13, 1, 1, STATE, GpsData)                                     \
  PLAYER_MESSAGE(bumper, 14, 1, 1, STATE, BumperData)                               \
  PLAYER_MESSAGE(bumper, 14, 1, 2, GEOM, BumperGeom)                                \
  PLAYER_MESSAGE(bumper, 14, 3, 1, GET_GEOM, BumperGeom)                            \
  PLAYER_MESSAGE(dio, 20, 1, 1, VALUES, DioData)                                    \
  PLAYER_MESSAGE(dio, 20, 2, 1, VALUES, DioCmd)                                     \
  PLAYER_MESSAGE(aio, 21, 2, 1, STATE, AioCmd)                                      \
  PLAYER_MESSAGE(aio, 21, 1, 1, STATE, AioData)                                     \
  PLAYER_MESSAGE(ir, 22, 3, 1, POSE, IrPose)                                        \
  PLAYER_MESSAGE(ir, 22, 3, 2, POWER, IrPowerReq)                                   \
  PLAYER_MESSAGE(ir, 22, 1, 1, RANGES, IrData)                                      \
  PLAYER_MESSAGE(wifi, 23, 3, 1, MAC, WifiMacReq)                                   \
  PLAYER_MESSAGE(wifi, 23, 3, 2, IWSPY_ADD, WifiIwspyAddrReq)                       \
  PLAYER_MESSAGE(wifi, 23, 3, 3, IWSPY_DEL, WifiIwspyAddrReq)                       \
  PLAYER_MESSAGE(wifi, 23, 3, 4, IWSPY_PING, WifiIwspyAddrReq)                      \
  PLAYER_MESSAGE(wifi, 23, 1, 1, STATE, WifiData)                                   \
  PLAYER_MESSAGE(localize, 25, 1, 1, HYPOTHS, LocalizeData)                         \
  PLAYER_MESSAGE(localize, 25, 3, 1, SET_POSE, LocalizeSetPose)                     \
  PLAYER_MESSAGE(localize, 25, 3, 2, GET_PARTICLES, LocalizeGetParticles)           \
  PLAYER_MESSAGE(position3d, 30, 1, 1, STATE, Position3dData)                       \
  PLAYER_MESSAGE(position3d, 30, 1, 2, GEOMETRY, Position3dGeom)                    \
  PLAYER_MESSAGE(position3d, 30, 2, 1, SET_VEL, Position3dCmdVel)                   \
  PLAYER_MESSAGE(position3d, 30, 2, 2, SET_POS, Position3dCmdPos)                   \
  PLAYER_MESSAGE(position3d, 30, 3, 1, GET_GEOM, Position3dGeom)                    \
  PLAYER_MESSAGE(position3d, 30, 3, 2, MOTOR_POWER, Position3dPowerConfig)          \
  PLAYER_MESSAGE(position3d, 30, 3, 3, VELOCITY_MODE, Position3dVelocityModeConfig) \
  PLAYER_MESSAGE(position3d, 30, 3, 4, POSITION_MODE, Position3dPositionModeReq)    \
  PLAYER_MESSAGE(position3d, 30, 3, 6, SET_ODOM, Position3dSetOdomReq)              \
  PLAYER_MESSAGE(position3d, 30, 3, 7, SPEED_PID, Position3dSpeedPidReq)            \
  PLAYER_MESSAGE(position3d, 30, 3, 8, POSITION_PID, Position3dPositionPidReq)      \
  PLAYER_MESSAGE(position3d, 30, 3, 9, SPEED_PROF, Position3dSpeedProfReq)          \
  PLAYER_MESSAGE(simulation, 31, 3, 1, GET_POSE2D, SimulationPose2dReq)             \
  PLAYER_MESSAGE(simulation, 31, 3, 2, SET_POSE2D, SimulationPose2dReq)             \
  PLAYER_MESSAGE(simulation, 31, 3, 3, GET_POSE3D, SimulationPose3dReq)             \
  PLAYER_MESSAGE(simulation, 31, 3, 4, SET_POSE3D, SimulationPose3dReq)             \
  PLAYER_MESSAGE(simulation, 31, 3, 5, GET_PROPERTY, SimulationPropertyReq)         \
  PLAYER_MESSAGE(simulation, 31, 3, 6, SET_PROPERTY, SimulationPropertyReq)         \
  PLAYER_MESSAGE(blinkenlight, 33, 1, 1, STATE, BlinkenlightData)                   \
  PLAYER_MESSAGE(blinkenlight, 33, 2, 1, STATE, BlinkenlightCmd)                    \
  PLAYER_MESSAGE(blinkenlight, 33, 2, 2, POWER, BlinkenlightCmdPower)               \
  PLAYER_MESSAGE(blinkenlight, 33, 2, 3, COLOR, BlinkenlightCmdColor)               \
  PLAYER_MESSAGE(blinkenlight, 33, 2, 4, FLASH, BlinkenlightCmdFlash)               \
  PLAYER_MESSAGE(camera, 40, 1, 1, STATE, CameraData)                               \
  PLAYER_MESSAGE(camera, 40, 3, 1, GET_SOURCE, CameraSource)                        \
  PLAYER_MESSAGE(camera, 40, 3, 2, SET_SOURCE, CameraSource)                        \
  PLAYER_MESSAGE(camera, 40, 3, 3, GET_IMAGE, CameraData)                           \
  PLAYER_MESSAGE(map, 42, 1, 1, INFO, MapInfo)                                      \
  PLAYER_MESSAGE(map, 42, 3, 1, GET_INFO, MapInfo)                                  \
  PLAYER_MESSAGE(map, 42, 3, 2, GET_DATA, MapData)                                  \
  PLAYER_MESSAGE(map, 42, 3, 3, GET_VECTOR, MapDataVector)                          \
  PLAYER_MESSAGE(planner, 44, 1, 1, STATE, PlannerData)                             \
  PLAYER_MESSAGE(planner, 44, 2, 1, GOAL, PlannerCmd)                               \
  PLAYER_MESSAGE(planner, 44, 2, 2, START, PlannerCmd)                              \
  PLAYER_MESSAGE(planner, 44, 3, 1, GET_WAYPOINTS, PlannerWaypointsReq)             \
  PLAYER_MESSAGE(planner, 44, 3, 2, ENABLE, PlannerEnableReq)                       \
  PLAYER_MESSAGE(log, 45, 3, 1, SET_WRITE_STATE, LogSetWriteState)                  \
  PLAYER_MESSAGE(log, 45, 3, 2, SET_READ_STATE, LogSetReadState)                    \
  PLAYER_MESSAGE(log, 45, 3, 3, GET_STATE, LogGetState)                             \
  PLAYER_MESSAGE(log, 45, 3, 5, SET_FILENAME, LogSetFilename)                       \
  PLAYER_MESSAGE(joystick, 49, 1, 1, STATE, JoystickData)                           \
  PLAYER_MESSAGE(speech_recognition, 50, 1, 1, STRING, SpeechRecognitionData)       \
  PLAYER_MESSAGE(opaque, 51, 1, 1, STATE, OpaqueData)                               \
  PLAYER_MESSAGE(opaque, 51, 2, 1, DATA, OpaqueData)                                \
  PLAYER_MESSAGE(opaque, 51, 3, 1, DATA, OpaqueData)                                \
  PLAYER_MESSAGE(position1d, 52, 3, 1, GET_GEOM, Position1dGeom)                    \
  PLAYER_MESSAGE(position1d, 52, 3, 2, MOTOR_POWER, Position1dPowerConfig)          \
  PLAYER_MESSAGE(position1d, 52, 3, 3, VELOCITY_MODE, Position1dVelocityModeConfig) \
  PLAYER_MESSAGE(position1d, 52, 3, 4, POSITION_MODE, Position1dPositionModeReq)    \
  PLAYER_MESSAGE(position1d, 52, 3, 5, SET_ODOM, Position1dSetOdomReq)              \
  PLAYER_MESSAGE(position1d, 52, 3, 6, RESET_ODOM, Position1dResetOdomConfig)       \
  PLAYER_MESSAGE(position1d, 52, 3, 7, SPEED_PID, Position1dSpeedPidReq)            \
  PLAYER_MESSAGE(position1d, 52, 3, 8, POSITION_PID, Position1dPositionPidReq)      \
  PLAYER_MESSAGE(position1d, 52, 3, 9, SPEED_PROF, Position1dSpeedProfReq)          \
  PLAYER_MESSAGE(position1d, 52, 1, 1, STATE, Position1dData)                       \
  PLAYER_MESSAGE(position1d, 52, 1, 2, GEOM, Position1dGeom)                        \
  PLAYER_MESSAGE(position1d, 52, 2, 1, VEL, Position1dCmdVel)                       \
  PLAYER_MESSAGE(position1d, 52, 2, 2, POS, Position1dCmdPos)                       \
  PLAYER_MESSAGE(actarray, 53, 3, 1, POWER, ActarrayPowerConfig)                    \
  PLAYER_MESSAGE(actarray, 53, 3, 2, BRAKES, ActarrayBrakesConfig)                  \
  PLAYER_MESSAGE(actarray, 53, 3, 3, GET_GEOM, ActarrayGeom)                        \
  PLAYER_MESSAGE(actarray, 53, 3, 4, SPEED, ActarraySpeedConfig)                    \
  PLAYER_MESSAGE(actarray, 53, 3, 5, ACCEL, ActarrayAccelConfig)                    \
  PLAYER_MESSAGE(actarray, 53, 2, 1, POS, ActarrayPositionCmd)                      \
  PLAYER_MESSAGE(actarray, 53, 2, 2, MULTI_POS, ActarrayMultiPositionCmd)           \
  PLAYER_MESSAGE(actarray, 53, 2, 3, SPEED, ActarraySpeedCmd)                       \
  PLAYER_MESSAGE(actarray, 53, 2, 4, MULTI_SPEED, ActarrayMultiSpeedCmd)            \
  PLAYER_MESSAGE(actarray, 53, 2, 5, HOME, ActarrayHomeCmd)                         \
  PLAYER_MESSAGE(actarray, 53, 2, 6, CURRENT, ActarrayCurrentCmd)                   \
  PLAYER_MESSAGE(actarray, 53, 2, 7, MULTI_CURRENT, ActarrayMultiCurrentCmd)        \
  PLAYER_MESSAGE(actarray, 53, 1, 1, STATE, ActarrayData)                           \
  PLAYER_MESSAGE(limb, 54, 1, 1, STATE, LimbData)                                   \
  PLAYER_MESSAGE(limb, 54, 2, 3, SETPOSE, LimbSetposeCmd)                           \
  PLAYER_MESSAGE(limb, 54, 2, 4, SETPOSITION, LimbSetpositionCmd)                   \
  PLAYER_MESSAGE(limb, 54, 2, 5, VECMOVE, LimbVecmoveCmd)                           \
  PLAYER_MESSAGE(limb, 54, 3, 1, POWER, LimbPowerReq)                               \
  PLAYER_MESSAGE(limb, 54, 3, 2, BRAKES, LimbBrakesReq)                             \
  PLAYER_MESSAGE(limb, 54, 3, 3, GEOM, LimbGeomReq)                                 \
  PLAYER_MESSAGE(limb, 54, 3, 4, SPEED, LimbSpeedReq)                               \
  PLAYER_MESSAGE(graphics2d, 55, 2, 2, POINTS, Graphics2dCmdPoints)                 \
  PLAYER_MESSAGE(graphics2d, 55, 2, 3, POLYLINE, Graphics2dCmdPolyline)             \
  PLAYER_MESSAGE(graphics2d, 55, 2, 4, POLYGON, Graphics2dCmdPolygon)               \
  PLAYER_MESSAGE(graphics2d, 55, 2, 5, MULTILINE, Graphics2dCmdMultiline)           \
  PLAYER_MESSAGE(rfid, 56, 1, 1, TAGS, RfidData)                                    \
  PLAYER_MESSAGE(wsn, 57, 1, 1, STATE, WsnData)                                     \
  PLAYER_MESSAGE(wsn, 57, 2, 1, DEVSTATE, WsnCmd)                                   \
  PLAYER_MESSAGE(wsn, 57, 3, 1, POWER, WsnPowerConfig)                              \
  PLAYER_MESSAGE(wsn, 57, 3, 2, DATATYPE, WsnDatatypeConfig)                        \
  PLAYER_MESSAGE(wsn, 57, 3, 3, DATAFREQ, WsnDatafreqConfig)                        \
  PLAYER_MESSAGE(graphics3d, 58, 2, 2, DRAW, Graphics3dCmdDraw)                     \
  PLAYER_MESSAGE(graphics3d, 58, 2, 3, TRANSLATE, Graphics3dCmdTranslate)           \
  PLAYER_MESSAGE(graphics3d, 58, 2, 4, ROTATE, Graphics3dCmdRotate)                 \
  PLAYER_MESSAGE(health, 59, 1, 1, STATE, HealthData)                               \
  PLAYER_MESSAGE(imu, 60, 1, 1, STATE, ImuDataState)                                \
  PLAYER_MESSAGE(imu, 60, 1, 2, CALIB, ImuDataCalib)                                \
  PLAYER_MESSAGE(imu, 60, 1, 3, QUAT, ImuDataQuat)                                  \
  PLAYER_MESSAGE(imu, 60, 1, 4, EULER, ImuDataEuler)                                \
  PLAYER_MESSAGE(imu, 60, 1, 5, FULLSTATE, ImuDataFullstate)                        \
  PLAYER_MESSAGE(imu, 60, 3, 1, SET_DATATYPE, ImuDatatypeConfig)                    \
  PLAYER_MESSAGE(imu, 60, 3, 2, RESET_ORIENTATION, ImuResetOrientationConfig)       \
  PLAYER_MESSAGE(imu, 60, 3, 3, RESET_EULER, ImuResetEulerConfig)                   \
  PLAYER_MESSAGE(pointcloud3d, 61, 1, 1, STATE, Pointcloud3dData)                   \
  PLAYER_MESSAGE(ranger, 62, 1, 1, RANGE, RangerDataRange)                          \
  PLAYER_MESSAGE(ranger, 62, 1, 2, RANGESTAMPED, RangerDataRangestamped)            \
  PLAYER_MESSAGE(ranger, 62, 1, 3, INTNS, RangerDataIntns)                          \
  PLAYER_MESSAGE(ranger, 62, 1, 4, INTNSSTAMPED, RangerDataIntnsstamped)            \
  PLAYER_MESSAGE(ranger, 62, 1, 5, GEOM, RangerGeom)                                \
  PLAYER_MESSAGE(ranger, 62, 3, 1, GET_GEOM, RangerGeom)                            \
  PLAYER_MESSAGE(ranger, 62, 3, 2, POWER, RangerPowerConfig)                        \
  PLAYER_MESSAGE(ranger, 62, 3, 3, INTNS, RangerIntnsConfig)                        \
  PLAYER_MESSAGE(ranger, 62, 3, 4, SET_CONFIG, RangerConfig)                        \
  PLAYER_MESSAGE(ranger, 62, 3, 5, GET_CONFIG, RangerConfig)                        \
  PLAYER_MESSAGE(vectormap, 63, 3, 1, GET_MAP_INFO, VectormapInfo)                  \
  PLAYER_MESSAGE(vectormap, 63, 3, 3, GET_LAYER_DATA, VectormapLayerData)           \
  PLAYER_MESSAGE(vectormap, 63, 3, 4, WRITE_LAYER, VectormapLayerData)              \
  PLAYER_MESSAGE(blackboard, 64, 3, 1, SUBSCRIBE_TO_KEY, BlackboardEntry)           \
  PLAYER_MESSAGE(blackboard, 64, 3, 2, UNSUBSCRIBE_FROM_KEY, BlackboardEntry)       \
  PLAYER_MESSAGE(blackboard, 64, 3, 3, SET_ENTRY, BlackboardEntry)                  \
  PLAYER_MESSAGE(blackboard, 64, 3, 4, SUBSCRIBE_TO_GROUP, BlackboardEntry)         \
  PLAYER_MESSAGE(blackboard, 64, 3, 5, UNSUBSCRIBE_FROM_GROUP, BlackboardEntry)     \
  PLAYER_MESSAGE(blackboard, 64, 3, 6, GET_ENTRY, BlackboardEntry)                  \
  PLAYER_MESSAGE(blackboard, 64, 1, 1, UPDATE, BlackboardEntry)                     \
  PLAYER_MESSAGE(stereo, 65, 1, 1, STATE, StereoData)                               \
  PLAYER_MESSAGE(coopobject, 66, 1, 1, HEALTH, CoopobjectHeader)                    \
  PLAYER_MESSAGE(coopobject, 66, 1, 2, RSSI, CoopobjectRssi)                        \
  PLAYER_MESSAGE(coopobject, 66, 1, 3, SENSOR, CoopobjectDataSensor)                \
  PLAYER_MESSAGE(coopobject, 66, 1, 4, ALARM, CoopobjectDataSensor)                 \
  PLAYER_MESSAGE(coopobject, 66, 1, 5, USERDEFINED, CoopobjectDataUserdefined)      \
  PLAYER_MESSAGE(coopobject, 66, 1, 6, REQUEST, CoopobjectReq)                      \
  PLAYER_MESSAGE(coopobject, 66, 1, 7, COMMAND, CoopobjectCmd)                      \
  PLAYER_MESSAGE(coopobject, 66, 1, 8, POSITION, CoopobjectPosition)                \
  PLAYER_MESSAGE(coopobject, 66, 2, 1, STANDARD, CoopobjectCmd)                     \
  PLAYER_MESSAGE(coopobject, 66, 2, 2, DATA, CoopobjectDataUserdefined)             \
  PLAYER_MESSAGE(coopobject, 66, 2, 3, POSITION, CoopobjectPosition)                \
  PLAYER_MESSAGE(coopobject, 66, 3, 1, STANDARD, CoopobjectReq)

#define CCMORSE_PLAYER_INTERFACES          \
  PLAYER_INTERFACE(player, 1)              \
  PLAYER_INTERFACE(power, 2)               \
  PLAYER_INTERFACE(gripper, 3)             \
  PLAYER_INTERFACE(position2d, 4)          \
  PLAYER_INTERFACE(sonar, 5)               \
  PLAYER_INTERFACE(laser, 6)               \
  PLAYER_INTERFACE(blobfinder, 7)          \
  PLAYER_INTERFACE(ptz, 8)                 \
  PLAYER_INTERFACE(audio, 9)               \
  PLAYER_INTERFACE(fiducial, 10)           \
  PLAYER_INTERFACE(speech, 12)             \
  PLAYER_INTERFACE(gps, 13)                \
  PLAYER_INTERFACE(bumper, 14)             \
  PLAYER_INTERFACE(dio, 20)                \
  PLAYER_INTERFACE(aio, 21)                \
  PLAYER_INTERFACE(ir, 22)                 \
  PLAYER_INTERFACE(wifi, 23)               \
  PLAYER_INTERFACE(localize, 25)           \
  PLAYER_INTERFACE(position3d, 30)         \
  PLAYER_INTERFACE(simulation, 31)         \
  PLAYER_INTERFACE(blinkenlight, 33)       \
  PLAYER_INTERFACE(camera, 40)             \
  PLAYER_INTERFACE(map, 42)                \
  PLAYER_INTERFACE(planner, 44)            \
  PLAYER_INTERFACE(log, 45)                \
  PLAYER_INTERFACE(joystick, 49)           \
  PLAYER_INTERFACE(speech_recognition, 50) \
  PLAYER_INTERFACE(opaque, 51)             \
  PLAYER_INTERFACE(position1d, 52)         \
  PLAYER_INTERFACE(actarray, 53)           \
  PLAYER_INTERFACE(limb, 54)               \
  PLAYER_INTERFACE(graphics2d, 55)         \
  PLAYER_INTERFACE(rfid, 56)               \
  PLAYER_INTERFACE(wsn, 57)                \
  PLAYER_INTERFACE(graphics3d, 58)         \
  PLAYER_INTERFACE(health, 59)             \
  PLAYER_INTERFACE(imu, 60)                \
  PLAYER_INTERFACE(pointcloud3d, 61)       \
  PLAYER_INTERFACE(ranger, 62)             \
  PLAYER_INTERFACE(vectormap, 63)          \
  PLAYER_INTERFACE(blackboard, 64)         \
  PLAYER_INTERFACE(stereo, 65)             \
  PLAYER_INTERFACE(coopobject, 66)
// NOLINTEND(cppcoreguidelines-macro-usage)

}  // namespace ccmorse::wire::player
