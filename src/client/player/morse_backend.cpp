#include "client/player/morse_backend.h"

#include <atomic>
#include <utility>

#include "client/core/subscription.h"
#include "client/player/morse_model.h"
#include "client/player/proxy_lookup.h"
#include "libCCMorse/MorseLaser.h"
#include "libCCMorse/MorseOdometry.h"
#include "libCCMorse/MorsePen.h"
#include "libCCMorse/MorsePose.h"
#include "libCCMorse/MorseRobot.h"
#include "wire/player/frame.h"

namespace CCMorse::playerlink {

/// A simulated device that a proxy has subscribed.
class MorseLink final : public DeviceLink {
 public:
  MorseLink(std::shared_ptr<MorseModel> model, PlayerCc::ClientProxy* proxy,
            const std::shared_ptr<DataSink>& sink)
      : client_(model->device().GetClient().shared_from_this()),
        model_(std::move(model)),
        sink_(sink),
        delivered_(std::make_shared<std::atomic<bool>>(false)),
        subscription_(std::make_shared<MorseSubscription>()) {
    // A proxy that is made after a Read() shows what is there, but does not call it data.
    model_->Deliver(*sink, false);
    subscription_->proxy = proxy;
    subscription_->device = &model_->device();
    subscription_->deliver = [model = model_, to = sink_, delivered = delivered_] {
      const std::shared_ptr<DataSink> taker = to.lock();
      if (!taker) return false;
      *delivered = true;
      return model->Deliver(*taker, true);
    };
    subscription_->signal = [to = sink_] {
      if (const std::shared_ptr<DataSink> taker = to.lock()) taker->Signal();
    };
    model_->device().GetRobot().AddSubscription(subscription_);
  }
  ~MorseLink() override { model_->device().GetRobot().RemoveSubscription(subscription_.get()); }
  MorseLink(const MorseLink&) = delete;
  MorseLink& operator=(const MorseLink&) = delete;

  void Command(std::uint8_t subtype, const wire::Body& body) override {
    model_->Command(subtype, body);
  }
  Answer Request(std::uint8_t subtype, const wire::Body& body, const TakeReply& take) override {
    Answer answer = model_->Request(subtype, body, take);
    if (model_->TakeChanged()) {
      if (const std::shared_ptr<DataSink> sink = sink_.lock()) model_->Deliver(*sink, *delivered_);
    }
    return answer;
  }
  std::string Driver() const override { return model_->device().GetName(); }
  MorseRobot* Robot() const override { return &model_->device().GetRobot(); }

 private:
  const std::shared_ptr<MorseClient> client_;  // keeps robot and device alive
  const std::shared_ptr<MorseModel> model_;
  const std::weak_ptr<DataSink> sink_;
  const std::shared_ptr<std::atomic<bool>> delivered_;  // whether a Read() brought data
  const std::shared_ptr<MorseSubscription> subscription_;
};

namespace {

constexpr char kSubscribe[] = "PlayerBackend::Subscribe()";

bool IsLaser(const MorseDevice& device) {
  return dynamic_cast<const MorseLaser*>(&device) != nullptr;
}

bool IsPen(const MorseDevice& device) { return dynamic_cast<const MorsePen*>(&device) != nullptr; }

bool IsPosition(const MorseDevice& device) {
  return dynamic_cast<const MorsePose*>(&device) != nullptr ||
         dynamic_cast<const MorseOdometry*>(&device) != nullptr;
}

// Without a table of proxies, the true pose stands for a robot; odometry is the second choice.
bool IsFirstChoice(const MorseDevice& device) {
  if (dynamic_cast<const MorsePose*>(&device) != nullptr) return true;
  return dynamic_cast<const MorseOdometry*>(&device) != nullptr &&
         device.GetRobot().FindDevice<MorsePose>() == nullptr;
}

bool HasTables(MorseClient& client) {
  for (const MorseRobot* robot : client.GetRobots()) {
    if (robot->HasProperties()) return true;
  }
  return false;
}

// The index-th device that fits, whatever the tables say.
MorseDevice& Nth(MorseClient& client, std::uint16_t index, const std::string& robot,
                 DeviceFilter fits, const char* what) {
  std::uint32_t count = 0;
  for (MorseDevice* device : client.GetDevices()) {
    if (!robot.empty() && device->GetRobot().GetName() != robot) continue;
    if (fits(*device) && count++ == index) return *device;
  }
  throw MorseError("there is no " + std::string(what) + ":" + std::to_string(index) + "; there " +
                       (count == 1 ? "is 1" : "are " + std::to_string(count)),
                   kSubscribe);
}

class MorseBackend final : public PlayerBackend {
 public:
  explicit MorseBackend(std::shared_ptr<MorseClient> client)
      : shared_(std::move(client)), client_(*shared_), kept_(client_.shared_from_this()) {}

  std::unique_ptr<DeviceLink> Subscribe(std::uint16_t interface_code, std::uint16_t index,
                                        const std::string& robot, PlayerCc::ClientProxy* proxy,
                                        std::shared_ptr<DataSink> sink) override {
    return std::make_unique<MorseLink>(Find(interface_code, index, robot), proxy, sink);
  }

  void Close() noexcept override { shared_.reset(); }

  bool Connected() override { return client_.Connected(); }
  void Read() override { client_.Read(); }
  bool Peek(std::uint32_t timeout_ms) override {
    return client_.Peek(static_cast<int>(timeout_ms));
  }
  void Run(std::uint32_t timeout_ms) override { client_.Run(static_cast<int>(timeout_ms)); }
  void Stop() override { client_.Stop(); }
  void StartThread() override { client_.StartThread(); }
  void StopThread() override { client_.StopThread(); }
  void SetRequestTimeout(double seconds) override { client_.SetRequestTimeout(seconds); }
  void SetRetryLimit(int limit) override { client_.SetRetryLimit(limit); }
  int GetRetryLimit() override { return client_.GetRetryLimit(); }
  void SetRetryTime(double seconds) override { client_.SetRetryTime(seconds); }
  double GetRetryTime() override { return client_.GetRetryTime(); }
  void SetDataMode(std::uint32_t mode) override { client_.SetDataMode(static_cast<int>(mode)); }
  void SetReplaceRule(bool replace, int type, int subtype, int interface_code) override {
    client_.SetReplaceRule(replace, type, subtype, interface_code);
  }
  void RequestDeviceList() override { client_.RequestDeviceList(); }
  std::list<playerc_device_info_t> GetDeviceList() override { return client_.GetDeviceList(); }
  std::string GetHostname() const override { return client_.GetHostname(); }
  std::uint32_t GetPort() const override { return client_.GetPort(); }
  std::uint32_t GetOverflowCount() override { return client_.GetOverflowCount(); }
  MorseClient* Morse() const override { return &client_; }

 private:
  std::shared_ptr<MorseModel> Find(std::uint16_t interface_code, std::uint16_t index,
                                   const std::string& robot) {
    switch (interface_code) {
      case PLAYER_POSITION2D_CODE:
        return MakePosition2d(FindProxyDevice(client_, "position2d", index, robot,
                                              HasTables(client_) ? IsPosition : IsFirstChoice,
                                              kSubscribe));
      case PLAYER_LASER_CODE:
        return MakeLaser(FindProxyDevice(client_, "laser", index, robot, IsLaser, kSubscribe));
      case PLAYER_RANGER_CODE:
        return MakeRanger(Nth(client_, index, robot, IsLaser, "ranger"));
      case PLAYER_GRAPHICS2D_CODE:
        return MakeGraphics2d(Nth(client_, index, robot, IsPen, "graphics2d"));
      case kWindowInterface:
        return MakeGraphics2d(Nth(client_, index, robot, IsPen, "pen"));
      case PLAYER_SIMULATION_CODE:
        return MakeSimulation(Nth(
            client_, index, robot, [](const MorseDevice&) { return true; }, "simulation"));
      default:
        throw MorseError(
            "the simulation has no " + std::string(wire::InterfaceName(interface_code)),
            kSubscribe);
    }
  }

  std::shared_ptr<MorseClient> shared_;  // counted: without it, the connection closes
  MorseClient& client_;
  const std::shared_ptr<MorseClient> kept_;  // its robots and devices, for proxies that are left
};

}  // namespace

std::unique_ptr<PlayerBackend> OpenSimulator(const std::string& host, int port) {
  return std::make_unique<MorseBackend>(MorseClient::Share(host, port));
}

}  // namespace CCMorse::playerlink
