#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "servers/player/drivers/driver.h"

namespace ccmorse::servers::player {

/// Player's "writelog": writes what the devices that it requires publish into a text file, a line a
/// message (docs/protocols/player.md), stamped with simulated time; it begins with what they answer
/// when they are asked for their geometry and configuration. Provides a log. Options: filename, or
/// basename (".log" is added; default "writelog"); autorecord (1: writes from the first user on; 0:
/// once a client says so). A file of that name is written anew when writing starts. A client may
/// name another file, while none is written: in the same folder, and none that is there already.
class WriteLog : public Driver {
 public:
  WriteLog(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);
  void Data(const DataMessage& message) override;

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Started() override;
  void Stopped() override { SetRecording(false); }

 private:
  bool SetRecording(bool on);
  void WriteLine(double time, const Device& device, wire::MessageType type, std::uint8_t subtype,
                 const wire::Bytes& body);

  const DeviceContext context_;
  std::vector<Device*> logged_;
  std::string file_;
  const bool autorecord_;
  std::ofstream out_;  // open while it records
};

/// Player's "readlog": provides devices, whose data come from a file of WriteLog at the same pace
/// of simulated time as they were written, stamped with the time when they come; requests for
/// geometry and configuration are answered as the file has them, all others are refused. Where the
/// file says so it may provide a log as well. Options: filename; autoplay (1: from the first user
/// on; 0: once a client says so); speed (1, how much faster). Stands at the file's end until it is
/// rewound. A line that is none, or of a device that it does not provide, is passed over.
class ReadLog : public Driver {
 public:
  ReadLog(const DriverDef& def, const DeviceContext& context, const DeviceList& devices);
  void Step() override;

 protected:
  bool Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) override;
  void Started() override;

 private:
  struct Line {
    double time = 0.0;  // s
    std::uint16_t interface_code = 0;
    std::uint16_t index = 0;
    wire::MessageType type = wire::MessageType::kData;
    std::uint8_t subtype = 0;
    wire::Bytes body;
  };
  struct Answer {
    std::uint8_t subtype;
    wire::Bytes body;
  };

  static std::optional<Line> Read(const std::string& text);
  bool Open();
  void ReadNext();

  const DeviceContext context_;
  const std::string file_;
  const bool autoplay_;
  const double speed_;
  Provided* log_ = nullptr;
  std::vector<Provided*> played_;
  std::map<const Device*, std::vector<Answer>> answers_;
  std::ifstream in_;
  std::optional<Line> next_;     // data that are yet to come
  std::optional<double> first_;  // s, of the file's first data
  double position_ = 0.0;        // s of the file since then
  std::optional<double> now_;    // s of the simulation, of the last step since it began
  bool playing_ = false;
};

}  // namespace ccmorse::servers::player
