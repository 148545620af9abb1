#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "servers/player/device.h"
#include "servers/player/device_context.h"

namespace ccmorse::servers::player {

/// A device that a driver provides or requires: "laser:0", or with a key that picks among several
/// of one interface, "input:::position2d:2" (specs: player.md C.2).
struct DriverDevice {
  std::string key;  ///< "" for none
  std::string interface_name;
  int index = 0;
};

/// What a driver is told by its file: numbers, texts and lists of them by name, and the units of
/// its lengths and angles.
struct DriverOptions {
  Json::Object values;
  double length_unit = 1.0;  ///< m in a length
  double angle_unit = 1.0;   ///< rad in an angle
  /// "FILE:LINE" of each of the values, in their order, where they come from a file.
  std::vector<std::string> places = {};
  /// Those that were asked for: others have no effect.
  mutable std::set<std::string, std::less<>> asked = {};

  // An option, or `fallback` where it is not given. Throws Error that names it, and its place, when
  // it is of another type.
  double Number(std::string_view name, double fallback) const;
  double Length(std::string_view name, double fallback) const;  ///< m
  double Angle(std::string_view name, double fallback) const;   ///< rad
  std::string Text(std::string_view name, const std::string& fallback) const;
  int Integer(std::string_view name, int fallback) const;  ///< within +-1e9
  bool Flag(std::string_view name, bool fallback) const;   ///< 1, 0, yes, no, true, false
  /// A tuple of as many numbers as `units` has letters: l in m, a in rad, f as written. Sets
  /// nothing where the option is not given.
  void Tuple(std::string_view name, std::string_view units, std::span<double> to) const;
  const Json* Find(std::string_view name) const;  ///< as given; nullptr: not given
  /// "FILE:LINE: " of the option, "" where that is not known.
  std::string Place(std::string_view name) const;

 private:
  [[noreturn]] void Fail(std::string_view name, const std::string& text) const;
};

/// A driver to be made.
struct DriverDef {
  std::string name;
  std::vector<DriverDevice> provided;
  std::vector<DriverDevice> required;
  DriverOptions options = {};
  std::string robot = "";  ///< of the scenario, for drivers that ask for one
  bool always_on = false;  ///< works also while nobody has subscribed
  /// Nobody asked for it: where it cannot be made, a warning is enough.
  bool may_fail = false;
};

/// A driver of the server (specs: player.md C.2, G): provides devices, and uses those of the
/// simulation or of other drivers, as their clients do, but without packing anything. It works
/// while anyone has subscribed to one of its devices. One thread.
class Driver : public Subscriber {
 public:
  /// `devices`: where those that it requires are; its own are yet to be added. Throws Error when
  /// one is missing.
  Driver(const DriverDef& def, const DeviceList& devices);
  /// The devices that it requires still exist then.
  ~Driver() override;
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  /// What it provides.
  const std::vector<std::shared_ptr<Device>>& provided() const { return provided_; }

  /// After each Simulation::Sense(), when all devices have published, while it works.
  virtual void Step() {}
  bool works() const { return users_ > 0; }
  /// It works from now on, or no longer, also while nobody has subscribed (.cfg: alwayson).
  void KeepOn(bool on);

  void Data(const DataMessage& /*message*/) override {}

 protected:
  /// One of its devices; what it is asked and told goes to the driver's Ask() and Tell().
  class Provided : public Device {
   public:
    Provided(Driver& driver, std::uint16_t interface_code, std::uint16_t index,
             const std::string& name, Capabilities capabilities)
        : Device(interface_code, index, name, capabilities), driver_(driver) {}
    using Device::AddCapability;
    using Device::Publish;

   protected:
    bool Ask(std::uint8_t subtype, const wire::Body& body, Reply& reply) override {
      return driver_.Ask(*this, subtype, body, reply);
    }
    void Tell(std::uint8_t subtype, const wire::Body& body) override {
      driver_.Tell(*this, subtype, body);
    }
    void FirstSubscribed() override { driver_.UserCame(); }
    void LastLeft() override { driver_.UserLeft(); }

   private:
    Driver& driver_;
  };

  /// Makes the device of an interface that the file says it provides; nullptr when it says nothing
  /// of it.
  Provided* Provide(std::uint16_t interface_code, Device::Capabilities capabilities,
                    std::string_view key = "");
  /// The device of an interface and index that the file says it provides, whatever they are.
  Provided* ProvideOne(std::uint16_t interface_code, int index);
  /// One that it requires, to which it subscribes while it works. With a key, one that has the key,
  /// or the only one of its interface. Throws Error when there is none.
  Device& Require(std::uint16_t interface_code, std::string_view key = "");
  /// The same; nullptr when the file names none.
  Device* RequireIfGiven(std::uint16_t interface_code, std::string_view key = "");

  /// All that the file names, in its order. Throws Error when one is missing.
  std::vector<Device*> RequireAll();

  virtual bool Ask(Provided& /*device*/, std::uint8_t /*subtype*/, const wire::Body& /*body*/,
                   Reply& /*reply*/) {
    return false;
  }
  virtual void Tell(Provided& /*device*/, std::uint8_t /*subtype*/, const wire::Body& /*body*/) {}
  /// Its first user has come: it has just subscribed to what it requires.
  virtual void Started() {}
  /// Its last user has left: it is about to unsubscribe.
  virtual void Stopped() {}

 private:
  void UserCame();
  void UserLeft();
  Device* RequireNamed(const DriverDevice& named);

  const DriverDef def_;
  const DeviceList& devices_;
  std::vector<std::shared_ptr<Device>> provided_;
  std::vector<Device*> required_;
  bool kept_on_ = false;
  int users_ = 0;  // kept on, and devices that somebody has subscribed to
};

/// Is there a driver of that name?
bool IsDriver(std::string_view name);

/// Makes a driver by its name. Throws Error that names those there are.
std::unique_ptr<Driver> MakeDriver(const DriverDef& def, const DeviceContext& context,
                                   const DeviceList& devices);

}  // namespace ccmorse::servers::player
