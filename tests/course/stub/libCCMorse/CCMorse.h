#pragma once

// A stand-in for the client library, for tests of the course's control loop without a simulator.
// It has the names and signatures that the program uses, records every call that matters, and lets
// a test decide what each Read() brings. The real MorseError and the real point type are used.

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "libCCMorse/MorseError.h"
#include "libCCMorse/Types.h"

namespace CCMorse {

// What the stand-in sees and says. One robot, one laser; reset by the tests' fixture.
struct StubWorld {
  // Called by Read() with its number, from 1, before new data count as arrived; may change the data
  // below, set the flags, throw or block. Without it every Read() brings a scan and a position.
  std::function<void(long)> on_read;
  int peeks_true = 0;  // how many calls of Peek() say that more is waiting

  std::vector<double> ranges = std::vector<double>(682, 5.0);  // m
  double min_angle = -2.35619449;                              // rad
  double scan_res = 0.0069096;                                 // rad
  double max_range = 5.0;                                      // m
  double time = 0.0;                                           // s, of the data
  double x = 0.0, y = 0.0, yaw = 0.0;                          // m, rad
  double x_speed = 0.0, y_speed = 0.0, yaw_speed = 0.0;        // m/s, rad/s
  bool laser_fresh = false, laser_valid = false;
  bool position_fresh = false, position_valid = false;

  std::string failing_class;  // the constructor of this class throws MorseError

  long reads = 0;
  std::mutex mutex;  // guards calls
  std::vector<std::string> calls;

  void Note(const std::string& call) {
    const std::lock_guard<std::mutex> lock(mutex);
    calls.push_back(call);
  }
  std::vector<std::string> Calls() {
    const std::lock_guard<std::mutex> lock(mutex);
    return calls;
  }
  void BringAll() { laser_fresh = laser_valid = position_fresh = position_valid = true; }
};

// The world of the test that runs; never null while a robot exists.
inline StubWorld*& World() {
  static StubWorld* world = nullptr;
  return world;
}

// Notes construction and destruction.
class StubObject {
 public:
  explicit StubObject(std::string name) : name_(std::move(name)) {
    if (World()->failing_class == name_) throw MorseError("no such device", name_ + "::" + name_);
    World()->Note("new " + name_);
  }
  ~StubObject() { World()->Note("delete " + name_); }
  StubObject(const StubObject&) = delete;
  StubObject& operator=(const StubObject&) = delete;

 private:
  std::string name_;
};

class PlayerClient {
 public:
  explicit PlayerClient(std::string host = "localhost", int port = 6665) : object_("PlayerClient") {
    World()->Note("connect " + host + ":" + std::to_string(port));
  }
  void Read() {
    StubWorld& world = *World();
    ++world.reads;
    if (world.on_read) {
      world.on_read(world.reads);
    } else {
      world.BringAll();
    }
  }
  bool Peek(int /*timeout_ms*/ = 0) { return World()->peeks_true-- > 0; }

 private:
  StubObject object_;
};

class LaserProxy {
 public:
  explicit LaserProxy(PlayerClient* /*client*/, std::uint32_t index = 0) : object_("LaserProxy") {
    World()->Note("laser index " + std::to_string(index));
  }
  bool IsFresh() const { return World()->laser_fresh; }
  bool IsValid() const { return World()->laser_valid; }
  void NotFresh() { World()->laser_fresh = false; }
  double GetDataTime() const { return World()->time; }
  std::uint32_t GetCount() const { return static_cast<std::uint32_t>(World()->ranges.size()); }
  double GetMaxRange() const { return World()->max_range; }
  double GetScanRes() const { return World()->scan_res; }
  double GetMinAngle() const { return World()->min_angle; }
  double GetMaxAngle() const { return GetBearing(GetCount() - 1); }
  double operator[](std::uint32_t index) const { return World()->ranges.at(index); }
  double GetBearing(std::uint32_t index) const {
    return World()->min_angle + index * World()->scan_res;
  }

 private:
  StubObject object_;
};

class Position2dProxy {
 public:
  explicit Position2dProxy(PlayerClient* /*client*/, std::uint32_t index = 0)
      : object_("Position2dProxy") {
    World()->Note("position2d index " + std::to_string(index));
  }
  bool IsFresh() const { return World()->position_fresh; }
  bool IsValid() const { return World()->position_valid; }
  void NotFresh() { World()->position_fresh = false; }
  void SetMotorEnable(bool enable) { World()->Note(enable ? "motors on" : "motors off"); }
  void SetSpeed(double v, double w) {
    World()->Note("speed " + std::to_string(v) + " " + std::to_string(w));
  }
  void SetOdometry(double x, double y, double yaw) {
    World()->Note("odometry " + std::to_string(x) + " " + std::to_string(y) + " " +
                  std::to_string(yaw));
  }
  double GetXPos() const { return World()->x; }
  double GetYPos() const { return World()->y; }
  double GetYaw() const { return World()->yaw; }
  double GetXSpeed() const { return World()->x_speed; }
  double GetYSpeed() const { return World()->y_speed; }
  double GetYawSpeed() const { return World()->yaw_speed; }

 private:
  StubObject object_;
};

#ifdef _MORSE
class WindowProxy {
 public:
  static WindowProxy& GetInstance(PlayerClient* /*client*/, int width, int height) {
    if (Instance() == nullptr) Instance() = new WindowProxy;
    World()->Note("window " + std::to_string(width) + " x " + std::to_string(height));
    return *Instance();
  }
  static WindowProxy& GetInstance() {
    if (Instance() == nullptr) throw MorseError("no window", "WindowProxy::GetInstance");
    return *Instance();
  }
  ~WindowProxy() { Instance() = nullptr; }
  int GetX(double x) const { return static_cast<int>(x / 0.02); }
  int GetY(double y) const { return static_cast<int>(y / 0.02); }
  void SetLine(int x0, int y0, int x1, int y1, int r, int g, int b) {
    World()->Note("line " + Text({x0, y0, x1, y1}) + " colour " + Text({r, g, b}));
  }
  void SetPixel(int x, int y, int r, int g, int b) {
    World()->Note("pixel " + Text({x, y}) + " colour " + Text({r, g, b}));
  }

 private:
  WindowProxy() : object_("WindowProxy") {}
  static WindowProxy*& Instance() {
    static WindowProxy* instance = nullptr;
    return instance;
  }
  static std::string Text(const std::vector<int>& numbers) {
    std::string text;
    for (const int number : numbers) {
      if (!text.empty()) text += ',';
      text += std::to_string(number);
    }
    return text;
  }
  StubObject object_;
};

constexpr double PI = 3.14159265359;
#endif  // _MORSE

}  // namespace CCMorse
