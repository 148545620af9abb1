#include <algorithm>
#include <cmath>
#include <vector>

#include "client/player/proxy_lookup.h"
#include "libCCMorse/LaserProxy.h"
#include "libCCMorse/MorseLaser.h"
#include "libCCMorse/MorsePose.h"

namespace CCMorse {

namespace {

constexpr double kScannerSize = 0.15;  // m, what Player assumes

bool IsLaser(const MorseDevice& device) {
  return dynamic_cast<const MorseLaser*>(&device) != nullptr;
}

}  // namespace

LaserProxy::LaserProxy(PlayerClient* client, std::uint32_t index, const std::string& robot)
    : LaserProxy(client, index,
                 FindProxyDevice(RequireClient(client, "LaserProxy::LaserProxy()"), "laser", index,
                                 robot, IsLaser, "LaserProxy::LaserProxy()")) {}

LaserProxy::LaserProxy(PlayerClient* client, std::uint32_t index, MorseDevice& laser)
    : MorseProxy(client, index, "laser", laser), laser_(&dynamic_cast<MorseLaser&>(laser)) {}

LaserProxy::~LaserProxy() = default;

std::uint32_t LaserProxy::GetCount() const {
  return static_cast<std::uint32_t>(laser_->GetCount());
}
double LaserProxy::GetMaxRange() const { return laser_->GetMaxRange(); }
double LaserProxy::GetScanRes() const { return laser_->GetResolution(); }
double LaserProxy::GetRangeRes() const { return 0.0; }
double LaserProxy::GetScanningFrequency() const { return laser_->GetFrequency(); }
double LaserProxy::GetMinAngle() const { return laser_->GetMinAngle(); }
double LaserProxy::GetMaxAngle() const { return laser_->GetMaxAngle(); }
double LaserProxy::GetConfMinAngle() const { return laser_->GetMinAngle(); }
double LaserProxy::GetConfMaxAngle() const { return laser_->GetMaxAngle(); }
bool LaserProxy::IntensityOn() const { return false; }

double LaserProxy::GetRange(std::uint32_t index) const {
  try {
    return laser_->GetRange(index);
  } catch (const MorseError& error) {
    throw MorseError(error.GetErrorStr(), "LaserProxy::GetRange()");
  }
}

double LaserProxy::GetBearing(std::uint32_t index) const { return laser_->GetBearing(index); }

player_point_2d_t LaserProxy::GetPoint(std::uint32_t index) const {
  const double range = GetRange(index);
  const double bearing = GetBearing(index);
  return {range * std::cos(bearing), range * std::sin(bearing)};
}

int LaserProxy::GetIntensity(std::uint32_t index) const {
  GetRange(index);  // throws beyond the scan
  return 0;
}

double LaserProxy::GetMinLeft() const {
  const std::vector<double> ranges = laser_->GetRanges();
  double shortest = GetMaxRange();
  for (std::size_t i = ranges.size() / 2 + 1; i < ranges.size(); ++i) {
    shortest = std::min(shortest, ranges[i]);
  }
  return shortest;
}

double LaserProxy::GetMinRight() const {
  const std::vector<double> ranges = laser_->GetRanges();
  double shortest = GetMaxRange();
  for (std::size_t i = 0; i < ranges.size() && i <= ranges.size() / 2; ++i) {
    shortest = std::min(shortest, ranges[i]);
  }
  return shortest;
}

void LaserProxy::Configure(double /*min_angle*/, double /*max_angle*/, std::uint32_t /*scan_res*/,
                           std::uint32_t /*range_res*/, bool /*intensity*/,
                           double /*scanning_frequency*/) {
  throw MorseError("not supported by this device: its settings stand in the scene",
                   "LaserProxy::Configure()");
}

void LaserProxy::RequestConfigure() {}

void LaserProxy::RequestID() {
  throw MorseError("not supported by this device", "LaserProxy::RequestID()");
}

int LaserProxy::GetID() const { return -1; }
void LaserProxy::RequestGeom() {}
player_pose3d_t LaserProxy::GetPose() const { return laser_->GetMounting(); }

player_pose3d_t LaserProxy::GetRobotPose() const {
  const MorsePose* pose = GetRobot().FindDevice<MorsePose>();
  return pose ? pose->GetPose() : player_pose3d_t();
}

player_bbox3d_t LaserProxy::GetSize() const { return {kScannerSize, kScannerSize, 0.0}; }

std::ostream& operator<<(std::ostream& out, const LaserProxy& proxy) {
  const std::uint32_t count = proxy.GetCount();
  out << "#Laser (" << proxy.GetInterface() << ":" << proxy.GetIndex() << ")\n"
      << "#min: " << proxy.GetMinAngle() << "\tmax: " << proxy.GetMaxAngle()
      << "\tres: " << proxy.GetScanRes() << "\tcount: " << count << "\n"
      << "#range\tbearing\n";
  try {
    for (std::uint32_t i = 0; i < count; ++i) {
      out << proxy.GetRange(i) << "\t" << proxy.GetBearing(i) << "\n";
    }
  } catch (const MorseError&) {
    // A shorter scan came meanwhile: what was printed stands.
  }
  return out;
}

}  // namespace CCMorse
