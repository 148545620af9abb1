// The program of the dead reckoning task: turns once on the spot and goes half a metre for the
// calibration, and then along a tour through the hall, twice, by what it believes. reckoning.cc is
// yours. What the robot believes is drawn in green, the tour in orange.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "reckoning.h"

namespace {

constexpr double TURN = 2 * 3.14159265358979323846;
constexpr imr::SPose START = {0.90, 2.00, 0.0};
constexpr double STRAIGHT = 0.5;    // m of the calibration, as counted
constexpr double SPEED = 0.2;       // m/s
constexpr double TURN_SPEED = 0.6;  // rad/s
constexpr std::array<imr::SPoint, 5> TOUR = {
    {{2.34, 2.00}, {2.34, 2.80}, {1.62, 2.50}, {0.90, 2.80}, {0.90, 2.00}}};
constexpr std::size_t CORNERS = 2 * TOUR.size();

class CTour : public imr::CBehaviour {
 public:
  CTour() { reckoning.begin(START); }

  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch& sketch) override {
    if (senses.since == 0.0) {
      last = senses.pose;
      draw(sketch);
    }
    reckoning.advance(last, senses.pose);
    turned += std::remainder(senses.pose.yaw - last.yaw, TURN);
    went += std::hypot(senses.pose.x - last.x, senses.pose.y - last.y);
    last = senses.pose;
    const double moving = std::fabs(command.v) + std::fabs(command.w);
    command = {};
    // A scan from a robot that stands, at the beginning and end of either calibration.
    if (moving == 0.0) stand(senses);
    if (phase == TURNING && turned < TURN) command = {0.0, TURN_SPEED};
    if (phase == GOING && went < STRAIGHT) command = {SPEED, 0.0};
    if (phase == TOURING) command = towards();
    // Whoever believes to be elsewhere still does not touch the walls.
    if (senses.scan.nearestRange(-0.8, 0.8) < 0.12) command.v = 0.0;
    finished = finished || senses.time > 150.0;
    return command;
  }
  bool done() const override { return finished; }
  const imr::SPose* estimate() const override { return &reckoning.getPose(); }

 private:
  enum EPhase { BEFORE, TURNING, GOING, TOURING };
  static constexpr imr::CSketch::SInk WANTED = {"tour", 255, 165, 0};

  static void draw(imr::CSketch& sketch) {
    for (std::size_t i = 0; i < TOUR.size(); ++i) {
      sketch.line(WANTED, TOUR[i], TOUR[(i + 1) % TOUR.size()]);
    }
  }

  void stand(const imr::SSenses& senses) {
    if (phase == BEFORE) {
      phase = TURNING;
    } else if (phase == TURNING && turned >= TURN) {
      reckoning.calibrateTurn(before, senses.scan, turned);
      phase = GOING;
    } else if (phase == GOING && went >= STRAIGHT) {
      reckoning.calibrateWay(before, senses.scan, went);
      phase = TOURING;
      return;
    } else {
      return;
    }
    before = senses.scan;
    turned = 0.0;
    went = 0.0;
  }

  imr::SSpeed towards() {
    const imr::SPose& pose = reckoning.getPose();
    const imr::SPoint& to = TOUR[corner % TOUR.size()];
    const double distance = std::hypot(to.x - pose.x, to.y - pose.y);
    if (distance < 0.03) {
      ++corner;
      finished = corner >= CORNERS;
      return {};
    }
    const double turn = std::remainder(std::atan2(to.y - pose.y, to.x - pose.x) - pose.yaw, TURN);
    const double w = std::clamp(3.0 * turn, -TURN_SPEED, TURN_SPEED);
    return {std::fabs(turn) < 0.2 ? std::min(SPEED, 2.0 * distance) : 0.0, w};
  }

  CReckoning reckoning;
  imr::SPose last;  // of the odometry
  imr::SScan before;
  imr::SSpeed command;
  double turned = 0.0;  // rad, as counted since the phase began
  double went = 0.0;    // m
  EPhase phase = BEFORE;
  std::size_t corner = 0;
  bool finished = false;
};

}  // namespace

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::CRobotProgram::addOptions(config, 0);
  imr::SProgram about;
  about.about = "Drives a tour by a faulty odometry, and says where it is in the end.";
  about.examples = {"", "--save tour"};
  return imr::CRobotProgram::main(argc, argv, config, about, [] {
    imr::CRobotProgram::Behaviours behaviours;
    behaviours.push_back(std::make_unique<CTour>());
    return behaviours;
  });
}
