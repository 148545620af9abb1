#include "libplayerc++/navigation.h"

#include <algorithm>

#include "client/player/proxy_state.h"
#include "wire/player/deflate.h"

namespace PlayerCc {

namespace {

using GpsState = SimpleState<wire::GpsData, PLAYER_GPS_DATA_STATE>;

class ImuState : public ProxyState {
 public:
  wire::Pose3d pose;
  wire::ImuDataCalib raw;

 protected:
  bool Take(std::uint8_t subtype, const wire::Body& body) override {
    switch (subtype) {
      case PLAYER_IMU_DATA_STATE: {
        wire::ImuDataState state;
        if (!body.To(state)) return false;
        pose = state.pose;
        return true;
      }
      case PLAYER_IMU_DATA_CALIB:
        return Keep(body, raw);
      case PLAYER_IMU_DATA_QUAT: {
        wire::ImuDataQuat state;
        if (!body.To(state)) return false;
        raw = state.calib_data;
        return true;
      }
      case PLAYER_IMU_DATA_EULER: {
        wire::ImuDataEuler state;
        if (!body.To(state)) return false;
        raw = state.calib_data;
        pose.proll = state.orientation.proll;
        pose.ppitch = state.orientation.ppitch;
        pose.pyaw = state.orientation.pyaw;
        return true;
      }
      case PLAYER_IMU_DATA_FULLSTATE: {
        wire::ImuDataFullstate state;
        if (!body.To(state)) return false;
        pose = state.pose;
        return true;
      }
      default:
        return false;
    }
  }
};

class LocalizeState : public SimpleState<wire::LocalizeData, PLAYER_LOCALIZE_DATA_HYPOTHS> {
 public:
  wire::LocalizeGetParticles particles;
};

class MapState : public SimpleState<wire::MapInfo, PLAYER_MAP_DATA_INFO> {
 public:
  std::vector<std::int8_t> cells;  // data.width times data.height, once they were asked for
  std::int8_t range = 0;
};

class PlannerState : public SimpleState<wire::PlannerData, PLAYER_PLANNER_DATA_STATE> {
 public:
  PlannerState() { data.waypoint_idx = -1; }
  wire::PlannerWaypointsReq path;
};

class VectorMapState : public NoState {
 public:
  wire::VectormapInfo info;
  std::vector<wire::VectormapLayerData> layers;
};

constexpr std::uint32_t kTile = 640;             // cells of an edge, what Player asks for at most
constexpr std::uint64_t kMostCells = 1U << 28U;  // of a map

}  // namespace

// --- GpsProxy

GpsProxy::GpsProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "GpsProxy", "gps", std::make_shared<GpsState>()) {}
GpsProxy::~GpsProxy() = default;

// The message has 1e-7 degrees, mm, cm and tenths (specs: player.md B.7).
double GpsProxy::GetLatitude() const { return In<GpsState>()->data.latitude / 1e7; }
double GpsProxy::GetLongitude() const { return In<GpsState>()->data.longitude / 1e7; }
double GpsProxy::GetAltitude() const { return In<GpsState>()->data.altitude / 1e3; }
double GpsProxy::GetSpeed() const { return In<GpsState>()->data.speed; }
double GpsProxy::GetCourse() const { return In<GpsState>()->data.course; }
std::uint32_t GpsProxy::GetSatellites() const { return In<GpsState>()->data.num_sats; }
std::uint32_t GpsProxy::GetQuality() const { return In<GpsState>()->data.quality; }
double GpsProxy::GetHdop() const { return In<GpsState>()->data.hdop / 10.0; }
double GpsProxy::GetVdop() const { return In<GpsState>()->data.vdop / 10.0; }
double GpsProxy::GetUtmEasting() const { return In<GpsState>()->data.utm_e / 100.0; }
double GpsProxy::GetUtmNorthing() const { return In<GpsState>()->data.utm_n / 100.0; }
double GpsProxy::GetTime() const {
  const auto state = In<GpsState>();
  return state->data.time_sec + state->data.time_usec * 1e-6;
}
double GpsProxy::GetErrHorizontal() const { return In<GpsState>()->data.err_horz; }
double GpsProxy::GetErrVertical() const { return In<GpsState>()->data.err_vert; }

// --- ImuProxy

ImuProxy::ImuProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "ImuProxy", "imu", std::make_shared<ImuState>()) {}
ImuProxy::~ImuProxy() = default;

player_pose3d_t ImuProxy::GetPose() const { return ToC(In<ImuState>()->pose); }
float ImuProxy::GetXAccel() { return Single(In<ImuState>()->raw.accel_x); }
float ImuProxy::GetYAccel() { return Single(In<ImuState>()->raw.accel_y); }
float ImuProxy::GetZAccel() { return Single(In<ImuState>()->raw.accel_z); }
float ImuProxy::GetXGyro() { return Single(In<ImuState>()->raw.gyro_x); }
float ImuProxy::GetYGyro() { return Single(In<ImuState>()->raw.gyro_y); }
float ImuProxy::GetZGyro() { return Single(In<ImuState>()->raw.gyro_z); }
float ImuProxy::GetXMagn() { return Single(In<ImuState>()->raw.magn_x); }
float ImuProxy::GetYMagn() { return Single(In<ImuState>()->raw.magn_y); }
float ImuProxy::GetZMagn() { return Single(In<ImuState>()->raw.magn_z); }
player_imu_data_calib_t ImuProxy::GetRawValues() const {
  const wire::ImuDataCalib raw = In<ImuState>()->raw;
  return {Single(raw.accel_x), Single(raw.accel_y), Single(raw.accel_z),
          Single(raw.gyro_x),  Single(raw.gyro_y),  Single(raw.gyro_z),
          Single(raw.magn_x),  Single(raw.magn_y),  Single(raw.magn_z)};
}
void ImuProxy::SetDatatype(int datatype) {
  Require(Ask(*state_, PLAYER_IMU_REQ_SET_DATATYPE,
              wire::ImuDatatypeConfig{static_cast<std::uint8_t>(datatype)}),
          "ImuProxy::SetDatatype()");
}
void ImuProxy::ResetOrientation(int value) {
  Require(Ask(*state_, PLAYER_IMU_REQ_RESET_ORIENTATION,
              wire::ImuResetOrientationConfig{static_cast<std::uint32_t>(value)}),
          "ImuProxy::ResetOrientation()");
}
void ImuProxy::ResetEuler(float roll, float pitch, float yaw) {
  wire::ImuResetEulerConfig config;
  config.orientation.proll = roll;
  config.orientation.ppitch = pitch;
  config.orientation.pyaw = yaw;
  Require(Ask(*state_, PLAYER_IMU_REQ_RESET_EULER, config), "ImuProxy::ResetEuler()");
}

// --- LocalizeProxy

LocalizeProxy::LocalizeProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "LocalizeProxy", "localize", std::make_shared<LocalizeState>()) {}
LocalizeProxy::~LocalizeProxy() = default;

// No message of this interface tells of the map.
// NOLINTBEGIN(readability-convert-member-functions-to-static): Player's methods
std::uint32_t LocalizeProxy::GetMapSizeX() const { return 0; }
std::uint32_t LocalizeProxy::GetMapSizeY() const { return 0; }
std::uint32_t LocalizeProxy::GetMapTileX() const { return 0; }
std::uint32_t LocalizeProxy::GetMapTileY() const { return 0; }
double LocalizeProxy::GetMapScale() const { return 0.0; }
// NOLINTEND(readability-convert-member-functions-to-static)
std::uint32_t LocalizeProxy::GetPendingCount() const {
  return In<LocalizeState>()->data.pending_count;
}
std::uint32_t LocalizeProxy::GetHypothCount() const {
  return Count(In<LocalizeState>()->data.hypoths);
}
player_localize_hypoth_t LocalizeProxy::GetHypoth(std::uint32_t index) const {
  const auto state = In<LocalizeState>();
  const wire::LocalizeHypoth& each = At(state->data.hypoths, index, "LocalizeProxy::GetHypoth()");
  player_localize_hypoth_t hypoth{};
  hypoth.mean = ToC(each.mean);
  std::copy(each.cov.begin(), each.cov.end(), hypoth.cov);
  hypoth.alpha = each.alpha;
  return hypoth;
}
int LocalizeProxy::GetParticles() {
  wire::LocalizeGetParticles particles;
  if (!AskFor(*state_, PLAYER_LOCALIZE_REQ_GET_PARTICLES, particles).ok()) return -1;
  In<LocalizeState>()->particles = std::move(particles);
  return 0;
}
player_pose2d_t LocalizeProxy::GetParticlePose(int index) const {
  return ToC(At(In<LocalizeState>()->particles.particles, static_cast<std::size_t>(index),
                "LocalizeProxy::GetParticlePose()")
                 .pose);
}
void LocalizeProxy::SetPose(double pose[3], double cov[6]) {
  wire::LocalizeSetPose request;
  request.mean = {pose[0], pose[1], pose[2]};
  std::copy(cov, cov + 6, request.cov.begin());
  Require(Ask(*state_, PLAYER_LOCALIZE_REQ_SET_POSE, request), "LocalizeProxy::SetPose()");
}
std::uint32_t LocalizeProxy::GetNumHypoths() const { return GetHypothCount(); }
std::uint32_t LocalizeProxy::GetNumParticles() const {
  return Count(In<LocalizeState>()->particles.particles);
}

// --- MapProxy

MapProxy::MapProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "MapProxy", "map", std::make_shared<MapState>()) {}
MapProxy::~MapProxy() = default;

void MapProxy::RequestMap() {
  constexpr char kFunction[] = "MapProxy::RequestMap()";
  wire::MapInfo info;
  Require(AskFor(*state_, PLAYER_MAP_REQ_GET_INFO, info), kFunction);
  if (std::uint64_t{info.width} * info.height > kMostCells) {
    throw MorseError("the map is too large", kFunction);
  }
  std::vector<std::int8_t> cells(std::size_t{info.width} * info.height);
  std::int8_t range = 1;
  for (std::uint32_t row = 0; row < info.height; row += kTile) {
    for (std::uint32_t column = 0; column < info.width; column += kTile) {
      wire::MapData asked;
      asked.col = column;
      asked.row = row;
      asked.width = std::min(kTile, info.width - column);
      asked.height = std::min(kTile, info.height - row);
      wire::MapData tile;
      Require(AskFor(*state_, PLAYER_MAP_REQ_GET_DATA, wire::Body::Of(asked), tile), kFunction);
      const std::size_t size = std::size_t{asked.width} * asked.height;
      // A server without zlib sends the cells as they are.
      const auto inflated = tile.data.size() == size ? tile.data : wire::Inflate(tile.data, size);
      if (!inflated || inflated->size() != size || tile.width != asked.width ||
          tile.height != asked.height) {
        throw MorseError("a tile of the map cannot be read", kFunction);
      }
      range = tile.data_range;
      for (std::uint32_t y = 0; y < asked.height; ++y) {
        std::transform(inflated->begin() + std::ptrdiff_t{y} * asked.width,
                       inflated->begin() + std::ptrdiff_t{y + 1} * asked.width,
                       cells.begin() + std::ptrdiff_t{row + y} * info.width + column,
                       [](std::uint8_t cell) { return static_cast<std::int8_t>(cell); });
      }
    }
  }
  const auto state = In<MapState>();
  state->data = info;
  state->cells = std::move(cells);
  state->range = range;
}
int MapProxy::GetCellIndex(int x, int y) const {
  return y * static_cast<int>(In<MapState>()->data.width) + x;
}
std::int8_t MapProxy::GetCell(int x, int y) const {
  const auto state = In<MapState>();
  if (x < 0 || y < 0 || static_cast<std::uint32_t>(x) >= state->data.width) {
    throw MorseError("there is no such cell", "MapProxy::GetCell()");
  }
  return At(state->cells,
            static_cast<std::size_t>(y) * state->data.width + static_cast<std::size_t>(x),
            "MapProxy::GetCell()");
}
double MapProxy::GetResolution() const { return In<MapState>()->data.scale; }
std::uint32_t MapProxy::GetWidth() const { return In<MapState>()->data.width; }
std::uint32_t MapProxy::GetHeight() const { return In<MapState>()->data.height; }
double MapProxy::GetOriginX() const { return In<MapState>()->data.origin.px; }
double MapProxy::GetOriginY() const { return In<MapState>()->data.origin.py; }
std::int8_t MapProxy::GetDataRange() const { return In<MapState>()->range; }
void MapProxy::GetMap(std::int8_t* map) const {
  const auto state = In<MapState>();
  std::copy(state->cells.begin(), state->cells.end(), map);
}

// --- PlannerProxy

PlannerProxy::PlannerProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "PlannerProxy", "planner", std::make_shared<PlannerState>()) {}
PlannerProxy::~PlannerProxy() = default;

void PlannerProxy::SetGoalPose(double gx, double gy, double ga) {
  Command(*state_, PLAYER_PLANNER_CMD_GOAL, wire::PlannerCmd{{gx, gy, ga}});
}
void PlannerProxy::SetStartPose(double sx, double sy, double sa) {
  Command(*state_, PLAYER_PLANNER_CMD_START, wire::PlannerCmd{{sx, sy, sa}});
}
void PlannerProxy::RequestWaypoints() {
  wire::PlannerWaypointsReq path;
  Require(AskFor(*state_, PLAYER_PLANNER_REQ_GET_WAYPOINTS, path),
          "PlannerProxy::RequestWaypoints()");
  In<PlannerState>()->path = std::move(path);
}
void PlannerProxy::SetEnable(bool enable) {
  Require(Ask(*state_, PLAYER_PLANNER_REQ_ENABLE, wire::PlannerEnableReq{Flag(enable)}),
          "PlannerProxy::SetEnable()");
}
std::uint32_t PlannerProxy::GetPathValid() const { return In<PlannerState>()->data.valid; }
std::uint32_t PlannerProxy::GetPathDone() const { return In<PlannerState>()->data.done; }
double PlannerProxy::GetPathLength() const { return In<PlannerState>()->path.waypoints_distance; }
double PlannerProxy::GetPx() const { return GetPose().px; }
double PlannerProxy::GetPy() const { return GetPose().py; }
double PlannerProxy::GetPa() const { return GetPose().pa; }
player_pose2d_t PlannerProxy::GetPose() const { return ToC(In<PlannerState>()->data.pos); }
double PlannerProxy::GetGx() const { return GetGoal().px; }
double PlannerProxy::GetGy() const { return GetGoal().py; }
double PlannerProxy::GetGa() const { return GetGoal().pa; }
player_pose2d_t PlannerProxy::GetGoal() const { return ToC(In<PlannerState>()->data.goal); }
double PlannerProxy::GetWx() const { return GetCurrentWaypoint().px; }
double PlannerProxy::GetWy() const { return GetCurrentWaypoint().py; }
double PlannerProxy::GetWa() const { return GetCurrentWaypoint().pa; }
player_pose2d_t PlannerProxy::GetCurrentWaypoint() const {
  return ToC(In<PlannerState>()->data.waypoint);
}
double PlannerProxy::GetIx(int i) const { return GetWaypoint(static_cast<std::uint32_t>(i)).px; }
double PlannerProxy::GetIy(int i) const { return GetWaypoint(static_cast<std::uint32_t>(i)).py; }
double PlannerProxy::GetIa(int i) const { return GetWaypoint(static_cast<std::uint32_t>(i)).pa; }
player_pose2d_t PlannerProxy::GetWaypoint(std::uint32_t index) const {
  return ToC(At(In<PlannerState>()->path.waypoints, index, "PlannerProxy::GetWaypoint()"));
}
int PlannerProxy::GetCurrentWaypointId() const { return In<PlannerState>()->data.waypoint_idx; }
std::uint32_t PlannerProxy::GetWaypointCount() const {
  return Count(In<PlannerState>()->path.waypoints);
}
player_pose2d_t PlannerProxy::operator[](std::uint32_t index) const { return GetWaypoint(index); }

// --- VectorMapProxy

VectorMapProxy::VectorMapProxy(PlayerClient* client, std::uint32_t index)
    : ClientProxy(client, index, "VectorMapProxy", "vectormap",
                  std::make_shared<VectorMapState>()) {}
VectorMapProxy::~VectorMapProxy() = default;

void VectorMapProxy::GetMapInfo() {
  wire::VectormapInfo info;
  Require(AskFor(*state_, PLAYER_VECTORMAP_REQ_GET_MAP_INFO, info), "VectorMapProxy::GetMapInfo()");
  const auto state = In<VectorMapState>();
  state->layers.assign(info.layers.size(), wire::VectormapLayerData());
  state->info = std::move(info);
}
void VectorMapProxy::GetLayerData(unsigned int layer_index) {
  constexpr char kFunction[] = "VectorMapProxy::GetLayerData()";
  wire::VectormapLayerData asked;
  asked.name = At(In<VectorMapState>()->info.layers, layer_index, kFunction).name;
  wire::VectormapLayerData layer;
  Require(AskFor(*state_, PLAYER_VECTORMAP_REQ_GET_LAYER_DATA, wire::Body::Of(asked), layer),
          kFunction);
  const auto state = In<VectorMapState>();
  if (layer_index < state->layers.size()) state->layers[layer_index] = std::move(layer);
}
int VectorMapProxy::GetLayerCount() const {
  return static_cast<int>(In<VectorMapState>()->info.layers.size());
}
std::vector<std::string> VectorMapProxy::GetLayerNames() const {
  std::vector<std::string> names;
  const auto state = In<VectorMapState>();
  for (const wire::VectormapLayerInfo& layer : state->info.layers) names.push_back(layer.name);
  return names;
}
int VectorMapProxy::GetFeatureCount(unsigned int layer_index) const {
  const auto state = In<VectorMapState>();
  return static_cast<int>(
      At(state->layers, layer_index, "VectorMapProxy::GetFeatureCount()").features.size());
}
const std::uint8_t* VectorMapProxy::GetFeatureData(unsigned int layer_index,
                                                   unsigned int feature_index) const {
  constexpr char kFunction[] = "VectorMapProxy::GetFeatureData()";
  const auto state = In<VectorMapState>();
  return At(At(state->layers, layer_index, kFunction).features, feature_index, kFunction)
      .wkb.data();
}
std::size_t VectorMapProxy::GetFeatureDataCount(unsigned int layer_index,
                                                unsigned int feature_index) const {
  constexpr char kFunction[] = "VectorMapProxy::GetFeatureDataCount()";
  const auto state = In<VectorMapState>();
  return At(At(state->layers, layer_index, kFunction).features, feature_index, kFunction)
      .wkb.size();
}

}  // namespace PlayerCc
