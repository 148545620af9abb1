#include <utility>

#include "client/player/proxy_lookup.h"
#include "libCCMorse/MorseDriver.h"
#include "libCCMorse/MorseProperties.h"
#include "libCCMorse/PlayerClient.h"

namespace CCMorse {

MorseDriver::MorseDriver(PlayerClient* client, std::string name, const std::string& robot)
    : client_(client), name_(std::move(name)) {
  constexpr char kFunction[] = "MorseDriver::MorseDriver()";
  MorseClient& morse = RequireClient(client, kFunction);
  if (morse.GetRobots().empty()) throw MorseError("the simulation has no robot", kFunction);
  const MorseRobot& target = robot.empty() ? *morse.GetRobots().front() : morse.GetRobot(robot);
  if (const auto* properties = target.FindDevice<MorseProperties>()) {
    configuration_ = properties->GetDriver(name_);
  }
}

MorseDriver::~MorseDriver() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void MorseDriver::Start() {
  if (running_) throw MorseError("driver " + name_ + " runs already", "MorseDriver::Start()");
  if (thread_.joinable()) thread_.join();  // an earlier run that ended
  stop_ = false;
  error_ = nullptr;
  running_ = true;
  thread_ = std::thread([this] {
    try {
      Main();
    } catch (...) {
      error_ = std::current_exception();
    }
    running_ = false;
  });
}

void MorseDriver::Stop() { stop_ = true; }

void MorseDriver::Join() {
  if (!thread_.joinable()) return;
  thread_.join();
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

}  // namespace CCMorse
