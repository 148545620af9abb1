#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/component.h"
#include "sim/world.h"

namespace ccmorse::sim {

/// MORSE's SearchAndRescue (specs: morse.md B.2): `victim_dict`, of each robot or passive object
/// with a true property Injured that lies within Distance, m, and half of Angle, degrees, of the
/// sensor's x axis: name -> {coordinate: {x, y, z}, requirements: [...], severity}, from its
/// properties Requirements ("1,2,3") and Severity. It looks around Freq times a second. 6 Hz.
///
/// Services get_robot_abilities(), its property Abilities as a list; get_victim_requirements() and
/// get_victim_severity() of the nearest victim seen. heal(): where the nearest is less than
/// Heal_range away and needs one of the abilities, after ten activations those abilities are no
/// longer required of it; once nothing is, it is injured no more. Answers "Victim 'X' healed" or
/// "Victim 'X' partially healed"; FAILED without such a victim.
class SearchAndRescue : public Sensor {
 public:
  SearchAndRescue(Robot& robot, const std::string& name, World& world);
  ~SearchAndRescue() override;
  void Sample(const Instant& now) override;
  void Conclude(const Instant& now) override;
  void AddToHash(StateHash& hash) const override;
  void Reset() override;
  void Interrupt() override;

  // The cone that it looks into, as its properties say now.
  double angle() const { return angle_; }        ///< degrees, full aperture, 0..360
  double distance() const { return distance_; }  ///< m

 private:
  struct Victim {
    SceneObject* object;
    double distance;  // m, from the sensor
    Vec3 position;    // m
  };

  void AppendFields(std::string& out) const override;
  std::vector<Victim> Look();
  Victim Nearest();  // throws ServiceFailed
  void StartHealing(Completion done);
  void Finish(Outcome outcome, const std::string& text);

  World& world_;
  double heal_range_ = 5.0;  // Heal_range, m
  std::string abilities_;    // Abilities
  double angle_ = 60.0;      // Angle, degrees
  double distance_ = 10.0;   // Distance, m
  double look_rate_ = 3.0;   // Freq, Hz
  double next_look_ = 0.0;   // s
  std::vector<Victim> seen_;
  SceneObject* healing_ = nullptr;
  int activations_ = 0;  // since healing began
  Completion pending_;
};

}  // namespace ccmorse::sim
