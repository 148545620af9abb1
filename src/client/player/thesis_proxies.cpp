// The thesis's proxies: Player's, with what the thesis adds.

#include "client/player/proxy_state.h"
#include "libCCMorse/LaserProxy.h"
#include "libCCMorse/Position2dProxy.h"

namespace CCMorse {

LaserProxy::LaserProxy(PlayerClient* client, std::uint32_t index, const std::string& robot)
    : PlayerCc::LaserProxy(client, index, robot) {
  for (const auto request : {&LaserProxy::RequestConfigure, &LaserProxy::RequestGeom}) {
    try {
      (this->*request)();
    } catch (const MorseError&) {
      // A server that does not tell: zeros, as in Player.
    }
  }
}
LaserProxy::~LaserProxy() = default;

double LaserProxy::GetMaxAngle() const { return GetConfMaxAngle(); }

Position2dProxy::Position2dProxy(PlayerClient* client, std::uint32_t index,
                                 const std::string& robot)
    : PlayerCc::Position2dProxy(client, index, robot) {}
Position2dProxy::~Position2dProxy() = default;

player_pose2d_t Position2dProxy::GetPose() const {
  const std::lock_guard lock(state_->mutex);
  return {GetXPos(), GetYPos(), GetYaw()};
}

}  // namespace CCMorse
