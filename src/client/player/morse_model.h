#pragma once

#include <memory>
#include <optional>
#include <string>

#include "client/player/backend.h"
#include "libCCMorse/MorseClient.h"
#include "libCCMorse/MorseDevice.h"

namespace CCMorse::playerlink {

/// A simulated device in Player's shape: it makes Player's messages of the devices' data and does
/// what Player's commands and requests ask for. Any thread.
class MorseModel {
 public:
  /// `device`: of the simulation; its data decide when there is something to deliver.
  explicit MorseModel(MorseDevice& device) : device_(device) {}
  virtual ~MorseModel() = default;
  MorseModel(const MorseModel&) = delete;
  MorseModel& operator=(const MorseModel&) = delete;

  MorseDevice& device() const { return device_; }
  /// Hands the present data to `sink`. `valid`: whether they count as data.
  virtual bool Deliver(DataSink& sink, bool valid) = 0;
  virtual void Command(std::uint8_t subtype, const wire::Body& body) = 0;
  virtual Answer Request(std::uint8_t subtype, const wire::Body& body, const TakeReply& take) = 0;
  /// Whether a request has changed what Deliver() gives, since the last call.
  virtual bool TakeChanged() { return false; }

 protected:
  static Answer Refused(const std::string& why = "not supported by this device") {
    return {Answer::Kind::kNack, why};
  }
  bool Send(DataSink& sink, bool valid, std::uint8_t subtype, const wire::Body& body) const {
    return sink.OnData({subtype, device_.GetTimestamp(), valid && device_.IsValid(), body});
  }

 private:
  MorseDevice& device_;
};

/// The robot's own motion, from its pose sensor or odometry (position2d).
std::shared_ptr<MorseModel> MakePosition2d(MorseDevice& source);
/// A scanner as Player's laser and as its ranger.
std::shared_ptr<MorseModel> MakeLaser(MorseDevice& scanner);
std::shared_ptr<MorseModel> MakeRanger(MorseDevice& scanner);
/// A pen: as Player's graphics2d, and as what WindowProxy stands on.
std::shared_ptr<MorseModel> MakeGraphics2d(MorseDevice& pen);
/// The simulation itself; `any`: one of its devices.
std::shared_ptr<MorseModel> MakeSimulation(MorseDevice& any);

}  // namespace CCMorse::playerlink
