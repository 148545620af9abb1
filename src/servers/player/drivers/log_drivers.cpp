#include "servers/player/drivers/log_drivers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "base/error.h"
#include "base/log.h"
#include "wire/player/text.h"

namespace ccmorse::servers::player {
namespace {

using wire::MessageType;

constexpr std::uint8_t kReader = 1;  // of GET_STATE (specs: player.md B.7)
constexpr std::uint8_t kWriter = 2;

// Requests without a body whose answers tell how a device is.
struct Question {
  std::uint16_t interface_code;
  std::uint8_t subtype;
};
constexpr std::array kQuestions = {Question{wire::kPosition2d, wire::kPosition2dReqGetGeom},
                                   Question{wire::kLaser, wire::kLaserReqGetGeom},
                                   Question{wire::kLaser, wire::kLaserReqGetConfig},
                                   Question{wire::kRanger, wire::kRangerReqGetGeom},
                                   Question{wire::kRanger, wire::kRangerReqGetConfig},
                                   Question{wire::kSonar, wire::kSonarReqGetGeom},
                                   Question{wire::kIr, wire::kIrReqPose},
                                   Question{wire::kBumper, wire::kBumperReqGetGeom},
                                   Question{wire::kFiducial, wire::kFiducialReqGetGeom},
                                   Question{wire::kFiducial, wire::kFiducialReqGetFov}};

std::string FileName(const DriverOptions& options) {
  const std::string name = options.Text("filename", "");
  return name.empty() ? options.Text("basename", "writelog") + ".log" : name;
}

// A name of a file and not of a place.
bool IsPlainName(const std::string& name) {
  return !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
           c == '_' || c == '-';
  });
}

}  // namespace

WriteLog::WriteLog(const DriverDef& def, const DeviceContext& context, const DeviceList& devices)
    : Driver(def, devices),
      context_(context),
      logged_(RequireAll()),
      file_(FileName(def.options)),
      autorecord_(def.options.Flag("autorecord", true)) {
  if (Provide(wire::kLog, {{MessageType::kRequest, wire::kLogReqSetWriteState},
                           {MessageType::kRequest, wire::kLogReqGetState},
                           {MessageType::kRequest, wire::kLogReqSetFilename}}) == nullptr) {
    throw Error("driver writelog provides a log");
  }
  if (logged_.empty()) throw Error("driver writelog requires the devices that it is to log");
}

void WriteLog::Started() {
  if (autorecord_) SetRecording(true);
}

bool WriteLog::SetRecording(bool on) {
  if (on == out_.is_open()) return true;
  if (!on) {
    out_.close();
    return true;
  }
  out_.open(file_, std::ios::trunc);
  if (!out_) {
    LogWarning("driver writelog: cannot write {}", file_);
    out_.close();
    out_.clear();
    return false;
  }
  out_ << "## Messages of Player's devices, written by CCMorse: docs/protocols/player.md\n"
          "## time host robot interface index type subtype body\n";
  for (Device* const device : logged_) {
    for (const Question& question : kQuestions) {
      Reply reply;
      if (question.interface_code != device->interface_code() ||
          !device->Request(question.subtype, {}, reply)) {
        continue;
      }
      WriteLine(context_.simulation.time(), *device, MessageType::kAck, question.subtype,
                reply.body().ToBytes());
    }
  }
  return true;
}

void WriteLog::WriteLine(double time, const Device& device, MessageType type, std::uint8_t subtype,
                         const wire::Bytes& body) {
  const auto text = wire::ToText(device.interface_code(), type, subtype, body);
  if (!text) return;
  out_ << fmt::format("{} 0 0 {} {} {} {} {}\n", time, wire::InterfaceName(device.interface_code()),
                      device.index(), static_cast<int>(type), subtype, *text);
  if (out_) return;
  LogWarning("driver writelog: cannot write on in {}", file_);
  out_.clear();
  out_.close();
}

void WriteLog::Data(const DataMessage& message) {
  if (!out_.is_open()) return;
  WriteLine(message.time(), message.device(), MessageType::kData, message.subtype(),
            *message.bytes());
}

bool WriteLog::Ask(Provided& /*device*/, std::uint8_t subtype, const wire::Body& body,
                   Reply& reply) {
  switch (subtype) {
    case wire::kLogReqSetWriteState: {
      wire::LogSetWriteState wanted;
      return body.To(wanted) && SetRecording(wanted.state != 0);
    }
    case wire::kLogReqGetState:
      reply.Set(wire::LogGetState{kWriter, static_cast<std::uint8_t>(out_.is_open() ? 1 : 0)});
      return body.empty();
    default: {
      wire::LogSetFilename wanted;
      if (out_.is_open() || !body.To(wanted) || !IsPlainName(wanted.filename)) return false;
      const auto path = std::filesystem::path(file_).parent_path() / wanted.filename;
      std::error_code ignored;
      if (std::filesystem::exists(path, ignored)) return false;
      file_ = path.string();
      return true;
    }
  }
}

ReadLog::ReadLog(const DriverDef& def, const DeviceContext& context, const DeviceList& devices)
    : Driver(def, devices),
      context_(context),
      file_(def.options.Text("filename", "")),
      autoplay_(def.options.Flag("autoplay", true)),
      speed_(def.options.Number("speed", 1.0)) {
  if (file_.empty()) throw Error("driver readlog: filename is missing");
  if (!(speed_ > 0.0) || !std::isfinite(speed_)) {
    throw Error("driver readlog: speed must be more than 0");
  }
  log_ = Provide(wire::kLog, {{MessageType::kRequest, wire::kLogReqSetReadState},
                              {MessageType::kRequest, wire::kLogReqGetState},
                              {MessageType::kRequest, wire::kLogReqSetReadRewind}});
  for (const DriverDevice& each : def.provided) {
    const auto code = wire::InterfaceCode(each.interface_name);
    if (!code || *code == wire::kLog) continue;
    played_.push_back(ProvideOne(*code, each.index));
  }
  if (played_.empty()) throw Error("driver readlog provides the devices that it is to play");
  if (!Open()) throw Error("driver readlog: cannot read " + file_);
}

// "time host robot interface index type subtype body"; nothing for a line that is none.
std::optional<ReadLog::Line> ReadLog::Read(const std::string& text) {
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  Line line;
  std::string ignored;
  std::string interface_name;
  unsigned index = 0;
  unsigned type = 0;
  unsigned subtype = 0;
  if (!(words >> line.time >> ignored >> ignored >> interface_name >> index >> type >> subtype) ||
      !std::isfinite(line.time) || index > 0xffff || subtype > 0xff) {
    return {};
  }
  const auto code = wire::InterfaceCode(interface_name);
  line.type = static_cast<MessageType>(type);
  if (!code || (line.type != MessageType::kData && line.type != MessageType::kAck)) return {};
  line.interface_code = *code;
  line.index = static_cast<std::uint16_t>(index);
  line.subtype = static_cast<std::uint8_t>(subtype);
  std::string rest;
  std::getline(words >> std::ws, rest);
  auto body = wire::FromText(*code, line.type, line.subtype, rest);
  if (!body) return {};
  line.body = std::move(*body);
  return line;
}

// From the beginning, up to the first data.
bool ReadLog::Open() {
  in_.close();
  in_.clear();
  in_.open(file_);
  first_.reset();
  now_.reset();
  position_ = 0.0;
  if (!in_) return false;
  ReadNext();
  return true;
}

void ReadLog::ReadNext() {
  next_.reset();
  for (std::string text; !next_ && std::getline(in_, text);) {
    auto line = Read(text);
    if (!line) continue;
    for (Provided* const device : played_) {
      if (device->interface_code() != line->interface_code || device->index() != line->index) {
        continue;
      }
      if (line->type == MessageType::kData) {
        device->AddCapability(MessageType::kData, line->subtype);
        if (!first_) first_ = line->time;
        next_ = std::move(*line);
        break;
      }
      device->AddCapability(MessageType::kRequest, line->subtype);
      auto& answers = answers_[device];
      std::erase_if(answers, [&](const Answer& old) { return old.subtype == line->subtype; });
      answers.push_back({line->subtype, std::move(line->body)});
      break;
    }
  }
}

void ReadLog::Started() {
  now_.reset();
  playing_ = autoplay_;
}

void ReadLog::Step() {
  const double now = context_.simulation.time();
  if (playing_) position_ += (now - now_.value_or(now)) * speed_;
  now_ = now;
  if (!playing_) return;
  // Times such as 0.1 and 0.3 - 0.2 are the same.
  constexpr double kRounding = 1e-9;
  while (next_ && next_->time - *first_ <= position_ + kRounding) {
    for (Provided* const device : played_) {
      if (device->interface_code() == next_->interface_code && device->index() == next_->index) {
        device->Publish(next_->subtype, now, wire::Body(next_->body));
      }
    }
    ReadNext();
  }
}

bool ReadLog::Ask(Provided& device, std::uint8_t subtype, const wire::Body& body, Reply& reply) {
  if (&device != log_) {
    for (const Answer& each : answers_[&device]) {
      if (each.subtype != subtype || !body.empty()) continue;
      reply.SetBytes(each.body);
      return true;
    }
    return false;
  }
  switch (subtype) {
    case wire::kLogReqSetReadState: {
      wire::LogSetReadState wanted;
      if (!body.To(wanted)) return false;
      playing_ = wanted.state != 0;
      return true;
    }
    case wire::kLogReqGetState:
      reply.Set(wire::LogGetState{kReader, static_cast<std::uint8_t>(playing_ ? 1 : 0)});
      return body.empty();
    default:
      return body.empty() && Open();
  }
}

}  // namespace ccmorse::servers::player
