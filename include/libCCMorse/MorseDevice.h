#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "libCCMorse/MorseValue.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

class MorseClient;
class MorseRobot;

/// What a device is told about itself when the client makes it.
struct MorseDeviceInfo {
  MorseClient* client = nullptr;      ///< outlives the device
  MorseRobot* robot = nullptr;        ///< the robot that carries it; outlives the device
  std::string name;                   ///< full name in the simulation, "s1r.hokuyo"
  std::string type;                   ///< class in the simulation, "LaserScanner"; may be empty
  std::vector<std::string> services;  ///< what it can be asked for
};

/// A component of the simulation that stores data and can share them: base of all devices
/// (thesis 3.1.1). The client makes and owns every device; pointers stay good as long as the client
/// object lives, closed or not. Every method may be called from any thread.
///
/// A component for which no class is known is a plain MorseDevice: its data can be read with
/// GetData() after SetPolled(true), its services called with Command() and Request().
class MorseDevice {
 public:
  explicit MorseDevice(const MorseDeviceInfo& info);
  virtual ~MorseDevice();
  MorseDevice(const MorseDevice&) = delete;
  MorseDevice& operator=(const MorseDevice&) = delete;

  /// Full name, "s1r.hokuyo".
  const std::string& GetName() const { return info_.name; }
  /// Name without the robot, "hokuyo".
  std::string GetShortName() const;
  /// Class in the simulation, "LaserScanner"; empty when the simulator did not say.
  const std::string& GetType() const { return info_.type; }
  /// Whether the simulator offers service `name` of this device.
  bool HasService(const std::string& name) const;
  /// The robot that carries the device.
  MorseRobot& GetRobot() const { return *info_.robot; }
  /// The client that owns the device.
  MorseClient& GetClient() const { return *info_.client; }

  /// Whether data arrived at least once.
  bool HasData() const;
  /// Whether the last data were complete and made sense.
  bool IsValid() const;
  /// Simulated time of the last data, s; 0 before the first.
  double GetTimestamp() const;
  /// The last data as the simulator sent them; null before the first. On a fast link the first call
  /// asks for them, and from then on they come as text with each Read(), which costs time: prefer
  /// the getters of the device's class.
  MorseValue GetData() const;

  /// Whether MorseClient::Read() asks for this device's data.
  bool IsPolled() const;
  /// Turns the query of this device on or off: fewer devices make a faster Read(). Sensors of known
  /// classes start on. On a fast link poses, odometries and lasers are asked for with the first
  /// Read(), and then only if a proxy stands on them or a getter was called. Throws MorseError when
  /// the device has no data to ask for.
  void SetPolled(bool polled);

  /// Queues a one-way command: it leaves with the next Read() or request. Ignored once the
  /// connection is lost; a refusal comes out of the next Read() as a MorseError.
  void Command(const std::string& service, const MorseArgs& args = MorseArgs());
  /// Calls a service and waits for its answer; `timeout` in s, below 0: the client's. Throws
  /// MorseError when it is refused, late, or the connection is lost.
  MorseValue Request(const std::string& service, const MorseArgs& args = MorseArgs(),
                     double timeout = -1.0) const;

 protected:
  /// Guards every field that OnData() writes; getters of derived classes hold it while they copy.
  std::mutex& DataMutex() const;

  /// Services that are called once, without arguments, when the client has connected.
  virtual std::vector<std::string> SetupServices() const { return {}; }
  /// Takes the answer to one of SetupServices(). Before any other thread knows the device.
  virtual void OnSetup(const std::string& /*service*/, const MorseValue& /*answer*/) {}
  /// Takes new data; true when they are complete and make sense. Called with DataMutex() held, so
  /// it copies and calls none of the locking getters.
  virtual bool OnData(const MorseValue& /*data*/) { return true; }

  // --- The fast link (docs/protocols/fast-link.md); a class that knows nothing of it gets its data
  // by OnData() all the same.

  /// The forms in which data come without text.
  enum class DataForm : unsigned char {
    kText,      ///< none: by OnData()
    kPose,      ///< x, y, z, m; roll, pitch, yaw, rad
    kOdometry,  ///< as kPose; vx, vy, vz, m/s; wx, wy, wz, rad/s; stall, 0 or 1
    kScan,      ///< ranges, m
  };
  /// The form that OnNumbers() takes. A class derived from it may rely on OnData() alone, so a
  /// class gives its form only where `typeid` says that it is this class itself.
  virtual DataForm Form() const { return DataForm::kText; }
  /// As OnData(), for numbers of that form.
  virtual bool OnNumbers(const double* /*numbers*/, std::size_t /*count*/) { return false; }
  /// To be called by getters of classes with a form: data that nobody looks at are not sent.
  void Use() const {
    if (!in_use_.load(std::memory_order_relaxed)) StartUse();
  }

  /// As Command(service, MorseArgs(numbers...)), without text on a fast link.
  void CommandNumbers(const char* service, std::initializer_list<double> numbers);
  /// Cells of the canvas on a fast link; false, and nothing happened, where they have to go as a
  /// command.
  bool CommandImage(const char* service, int width, int height, const std::vector<Color_t>& image);
  bool CommandPixels(const char* service, const PixelUpdate_t* pixels, std::size_t count);

  /// Has the next Read() ask for something else, too, in the same message and without waiting for
  /// it any longer. `take` gets the answer in the thread that reads, under no lock; it is not
  /// called where there is none.
  void AskWithRead(const char* service, std::function<void(const MorseValue&)> take);

 private:
  friend class MorseClient;
  void StartUse() const;
  void Accept(const MorseValue& data);  // DataMutex() held
  void AcceptNumbers(double timestamp, const double* numbers, std::size_t count);  // the same

  const MorseDeviceInfo info_;
  mutable std::atomic<bool> in_use_{false};
  // Under DataMutex().
  bool polled_ = false;
  bool has_data_ = false;
  bool valid_ = false;
  double timestamp_ = 0.0;
  MorseValue data_;
  mutable bool wants_text_ = false;  // somebody calls GetData()
  bool data_missing_ = false;        // the last data came as numbers, data_ has them not
  std::uint64_t round_ = 0;          // the Read() that brought the last data
};

/// A class of devices as the client knows it (thesis 3.1.1).
struct MorseDeviceClass {
  /// Lower-case words, one of which should be part of a device's name: "hokuyo" finds "hokuyo_1".
  std::vector<std::string> identifiers;
  /// Classes in the simulation, "LaserScanner"; for devices that bear other names.
  std::vector<std::string> types;
  /// Makes the device.
  std::function<std::unique_ptr<MorseDevice>(const MorseDeviceInfo&)> make;
};

/// Makes a class of devices known to every client that connects from now on. A later class wins
/// over an earlier one with an equally long identifier. Returns true, so that one line at namespace
/// scope registers it. Any thread.
bool RegisterMorseDevice(MorseDeviceClass device_class);

// What a robot asks of its devices, whatever their classes. A device class derives from the roles
// that it can play; MorseRobot uses the first device of the robot that plays a role.

/// Knows where the robot is in the world.
class MorsePoseSource {
 public:
  virtual ~MorsePoseSource() = default;
  /// Whether GetPose() means anything yet.
  virtual bool HasPose() const = 0;
  /// Pose in the world, m and rad.
  virtual player_pose3d_t GetPose() const = 0;
};

/// Drives the robot by speeds.
class MorseSpeedControl {
 public:
  virtual ~MorseSpeedControl() = default;
  /// Forward speed, m/s, and turn rate, rad/s counter-clockwise.
  virtual void SetSpeed(double v, double w) = 0;
  /// Speeds 0.
  virtual void Stop() = 0;
};

/// Drives the robot to a place.
class MorseGoalControl {
 public:
  virtual ~MorseGoalControl() = default;
  /// Goal in the world, m; arrival within `tolerance`, m; at most `speed`, m/s.
  virtual void SetGoal(double x, double y, double tolerance, double speed) = 0;
  /// Gives the goal up.
  virtual void Stop() = 0;
};

/// Knows what does not change during a run: size, weight, proxies.
class MorsePropertySource {
 public:
  virtual ~MorsePropertySource() = default;
  /// All entries by key.
  virtual MorseValue GetAll() const = 0;
};

}  // namespace CCMorse
