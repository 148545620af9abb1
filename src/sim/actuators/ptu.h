#pragma once

#include <string>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// A pan-tilt unit: MORSE's PTU (specs: morse.md B.3). Turns what is mounted on it about its own z
/// (pan, to the left) and then y (tilt, down), both axes through its origin. Data and stream: pan,
/// tilt, rad. Each turns at Speed, rad/s, until within Tolerance, rad, of what was asked for; with
/// Manual nothing turns. Services: set_pan_tilt(pan, tilt), look_at_point(x, y, z) in the world, m,
/// and look_at_object(name), each answered without a value once it is there, and preempted by the
/// next; get_pan_tilt(). Where it looks is asked of the scene once, when the service is called. An
/// object that is not there FAILS, where MORSE 1.4 never answers.
class Ptu : public Actuator {
 public:
  Ptu(Robot& robot, const std::string& name, const World& world);
  ~Ptu() override;
  void Act(const Instant& now) override;
  void Receive(const Json& message) override;
  void AddToHash(StateHash&) const override {}  // what is mounted on it shows it
  void Reset() override;
  void Interrupt() override;
  Mount Carry(const Mount& at_rest) const override;

  double pan() const { return pan_; }    ///< rad, in (-pi, pi]
  double tilt() const { return tilt_; }  ///< rad, in (-pi, pi]

 private:
  void AppendFields(std::string& out) const override;
  void Start(double pan, double tilt, Completion done);
  void LookAt(const Vec3& point, Completion done);
  void Finish(Outcome outcome);

  const World& world_;
  double speed_ = 1.0;                      // Speed, rad/s
  double tolerance_ = 0.00523598775598298;  // Tolerance, rad
  bool manual_ = false;                     // Manual
  double pan_ = 0.0;                        // where it is
  double tilt_ = 0.0;
  double wanted_pan_ = 0.0;  // where it goes
  double wanted_tilt_ = 0.0;
  Completion pending_;
};

}  // namespace ccmorse::sim
