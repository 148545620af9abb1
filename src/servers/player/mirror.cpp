#include "servers/player/mirror.h"

#include <algorithm>
#include <array>
#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/log.h"
#include "base/trig.h"
#include "servers/net/stream_socket.h"
#include "sim/sensors/laser_scanner.h"
#include "wire/player/frame.h"

namespace ccmorse::servers {

namespace asio = boost::asio;
namespace wire_player = wire::player;
using asio::ip::tcp;

namespace {

constexpr auto kRetry = std::chrono::seconds(2);
constexpr std::array<std::uint16_t, 2> kPoseIndexes = {2, 0};  // the first that there is
constexpr std::uint8_t kOpen = 1;
constexpr std::uint8_t kPull = 2;
constexpr double kBlind = 0.02;  // m: what a Hokuyo reports below it is an error code

}  // namespace

MirrorTarget MirrorTarget::Parse(std::string_view text) {
  const auto refuse = [whole = std::string(text)]() -> MirrorTarget {
    throw Error("'" + whole +
                "' names no Player server to mirror; expected [ROBOT=]player://HOST[:PORT], as in "
                "s1r=player://syrotek:6665");
  };
  MirrorTarget target;
  if (const auto equals = text.find('='); equals != std::string_view::npos) {
    target.robot = text.substr(0, equals);
    if (target.robot.empty()) return refuse();
    text.remove_prefix(equals + 1);
  }
  constexpr std::string_view kScheme = "player://";
  if (text.starts_with(kScheme)) text.remove_prefix(kScheme.size());
  if (const auto colon = text.rfind(':'); colon != std::string_view::npos) {
    const std::string_view digits = text.substr(colon + 1);
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), target.port);
    if (error != std::errc() || end != digits.data() + digits.size() || target.port < 1 ||
        target.port > 65535) {
      return refuse();
    }
    text = text.substr(0, colon);
  }
  if (text.empty() || text.find('/') != std::string_view::npos) return refuse();
  target.host = text;
  return target;
}

// The connection; its handlers hold it, so that it outlives the mirror until they have run.
class Mirror::Link : public std::enable_shared_from_this<Mirror::Link> {
 public:
  Link(asio::io_context& io, sim::Simulation& simulation, ServiceDirectory& directory,
       const MirrorTarget& target)
      : directory_(directory),
        target_(target),
        server_("player://" + target.host + ":" + std::to_string(target.port)),
        resolver_(io),
        socket_(io),
        retry_(io) {
    sim::Robot* robot = target.robot.empty() && !simulation.robots().empty()
                            ? simulation.robots().front().get()
                            : simulation.FindRobot(target.robot);
    if (robot == nullptr) {
      throw Error("there is no robot '" + target.robot + "' to mirror " + server_);
    }
    target_.robot = robot->name();
    for (const auto& component : robot->components()) {
      if (scanner_ != nullptr) break;
      scanner_ = dynamic_cast<sim::LaserScanner*>(component.get());
    }
  }

  void Connect() {
    resolver_.async_resolve(
        target_.host, std::to_string(target_.port),
        [self = shared_from_this()](ErrorCode error, const tcp::resolver::results_type& found) {
          if (self->closed_) return;
          if (error) return self->Fail("cannot be found: " + error.message());
          asio::async_connect(self->socket_, found,
                              [self](ErrorCode failed, const tcp::endpoint& /*at*/) {
                                if (self->closed_) return;
                                if (failed)
                                  return self->Fail("cannot be reached: " + failed.message());
                                self->Connected();
                              });
        });
  }

  void Close() {
    closed_ = true;
    resolver_.cancel();
    retry_.cancel();
    ErrorCode ignored;
    socket_.close(ignored);
  }

 private:
  // What is to be done with the answer to a request: true for an ACK.
  using Answered = std::function<void(bool)>;

  void Connected() {
    ErrorCode ignored;
    socket_.set_option(tcp::no_delay(true), ignored);
    frames_ = wire_player::FrameReader(wire_player::kLongestBody);
    banner_left_ = wire_player::kBannerSize;
    answered_ = {};
    Read();
    wire_player::DeviceDatamodeReq pull;
    pull.mode = kPull;
    Request({0, 0, wire_player::kPlayer, 0}, wire_player::kPlayerReqDatamode,
            wire_player::Encode(pull), [this](bool /*ok*/) { OpenPose(0); });
  }

  void OpenPose(std::size_t attempt) {
    if (attempt == kPoseIndexes.size()) {
      return Fail("has neither position2d:2 nor position2d:0");
    }
    pose_index_ = kPoseIndexes[attempt];
    Open(wire_player::kPosition2d, pose_index_, [this, attempt](bool ok) {
      if (!ok) return OpenPose(attempt + 1);
      OpenLaser();
    });
  }

  void OpenLaser() {
    if (scanner_ == nullptr) return Begin(false);
    Open(wire_player::kLaser, 0, [this](bool ok) { Begin(ok); });
  }

  void Begin(bool scans) {
    LogInfo("{} shows position2d:{} {} of {}", target_.robot, pose_index_,
            scans ? "and laser:0" : "without a laser", server_);
    trouble_.clear();
    // A newer pose or scan takes the place of an older one that waits.
    wire_player::AddReplaceRuleReq newest{-1, -1, static_cast<int>(wire_player::MessageType::kData),
                                          -1, 1};
    Request({0, 0, wire_player::kPlayer, 0}, wire_player::kPlayerReqAddReplaceRule,
            wire_player::Encode(newest), [this](bool /*ok*/) { AskForData(); });
  }

  void AskForData() {
    Request({0, 0, wire_player::kPlayer, 0}, wire_player::kPlayerReqData, {}, {});
  }

  void Open(std::uint16_t interface_code, std::uint16_t index, Answered answered) {
    wire_player::DeviceReq open;
    open.addr = {0, 0, interface_code, index};
    open.access = kOpen;
    Request({0, 0, wire_player::kPlayer, 0}, wire_player::kPlayerReqDev, wire_player::Encode(open),
            std::move(answered));
  }

  void Request(const wire_player::Devaddr& to, std::uint8_t subtype, const wire_player::Bytes& body,
               Answered answered) {
    wire_player::Header header;
    header.address = to;
    header.type = wire_player::MessageType::kRequest;
    header.subtype = subtype;
    auto bytes = std::make_shared<std::string>();
    wire_player::Append(header, body, *bytes);
    answered_ = std::move(answered);
    asio::async_write(socket_, asio::buffer(*bytes),
                      [self = shared_from_this(), bytes](ErrorCode error, std::size_t /*size*/) {
                        if (error && !self->closed_) self->Fail("is lost: " + error.message());
                      });
  }

  void Read() {
    socket_.async_read_some(asio::buffer(block_),
                            [self = shared_from_this()](ErrorCode error, std::size_t size) {
                              if (self->closed_) return;
                              if (error == asio::error::eof) return self->Fail("has hung up");
                              if (error) return self->Fail("is lost: " + error.message());
                              std::string_view bytes(self->block_.data(), size);
                              const std::size_t banner = std::min(self->banner_left_, bytes.size());
                              self->banner_left_ -= banner;
                              bytes.remove_prefix(banner);
                              self->frames_.Append(bytes);
                              while (const auto message = self->frames_.Next()) {
                                self->Take(*message);
                                if (!self->socket_.is_open()) return;
                              }
                              if (self->frames_.broken())
                                return self->Fail("does not speak Player's protocol");
                              self->Read();
                            });
  }

  void Take(const wire_player::Message& message) {
    using Type = wire_player::MessageType;
    const wire_player::Devaddr& from = message.header.address;
    switch (message.header.type) {
      case Type::kAck:
      case Type::kNack: {
        const Answered answered = std::exchange(answered_, {});
        if (answered) answered(message.header.type == Type::kAck);
        return;
      }
      case Type::kData:
        if (from.interf == wire_player::kPosition2d && from.index == pose_index_ &&
            message.header.subtype == wire_player::kPosition2dDataState) {
          wire_player::Position2dData data;
          if (wire_player::Decode(message.body, data)) pose_ = data.pos;
        } else if (from.interf == wire_player::kLaser && from.index == 0 &&
                   message.header.subtype == wire_player::kLaserDataScan) {
          wire_player::LaserData data;
          if (wire_player::Decode(message.body, data)) scan_ = std::move(data);
        }
        return;
      case Type::kSynch:  // the end of a round
        Show();
        return AskForData();
      case Type::kCommand:
      case Type::kRequest:
        return;
    }
  }

  void Show() {
    if (const auto pose = std::exchange(pose_, {})) {
      Run("simulation", "mirror_pose",
          {Json(target_.robot), Json(Json::Array{pose->px, pose->py, pose->pa})});
    }
    if (const auto scan = std::exchange(scan_, {})) {
      Run(scanner_->full_name(), "mirror", {Json(Ranges(*scan))});
    }
  }

  // The scan as our scanner would have seen it.
  Json::Array Ranges(const wire_player::LaserData& scan) const {
    const sim::BeamFan& fan = scanner_->fan();
    Json::Array ranges;
    for (std::size_t i = 0; i < fan.count(); ++i) {
      const Vec3 direction = fan.Direction(i);
      const double beam =
          std::round((Atan2(direction.y, direction.x) - scan.min_angle) / scan.resolution);
      double range = fan.range();
      if (beam >= 0.0 && beam < static_cast<double>(scan.ranges.size())) {
        const double real = scan.ranges[static_cast<std::size_t>(beam)];
        if (real > kBlind && real < scan.max_range) range = std::min(real, fan.range());
      }
      ranges.emplace_back(range);
    }
    return ranges;
  }

  void Run(std::string_view component, std::string_view service, std::vector<Json> arguments) {
    directory_.Run(directory_.Find(component, service), arguments,
                   [this](const sim::ServiceResult& result) {
                     if (result.outcome == sim::Outcome::kSuccess) return;
                     Trouble("sends what cannot be shown: " + result.value.Dump());
                   });
  }

  void Fail(const std::string& what) {
    Trouble(what);
    ErrorCode ignored;
    socket_.close(ignored);
    retry_.expires_after(kRetry);
    retry_.async_wait([self = shared_from_this()](ErrorCode error) {
      if (!error && !self->closed_) self->Connect();
    });
  }

  // Once for each kind.
  void Trouble(const std::string& what) {
    if (what == trouble_) return;
    trouble_ = what;
    LogWarning("{} shows its last state: {} {}", target_.robot, server_, what);
  }

  ServiceDirectory& directory_;
  MirrorTarget target_;
  const std::string server_;
  sim::LaserScanner* scanner_ = nullptr;  // nullptr: the robot has none
  tcp::resolver resolver_;
  tcp::socket socket_;
  asio::steady_timer retry_;
  bool closed_ = false;
  std::array<char, std::size_t{16} << 10U> block_{};
  std::size_t banner_left_ = 0;
  wire_player::FrameReader frames_;
  Answered answered_;  // to the request that is outstanding
  std::uint16_t pose_index_ = 0;
  std::optional<wire_player::Pose2d> pose_;  // the newest of this round
  std::optional<wire_player::LaserData> scan_;
  std::string trouble_;  // that was logged last
};

Mirror::Mirror(asio::io_context& io, sim::Simulation& simulation, ServiceDirectory& directory,
               const MirrorTarget& target)
    : link_(std::make_shared<Link>(io, simulation, directory, target)) {
  link_->Connect();
}

Mirror::~Mirror() { link_->Close(); }

}  // namespace ccmorse::servers
