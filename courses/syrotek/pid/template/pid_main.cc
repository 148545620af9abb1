// The program of the PID task: the robot is to keep a line at constant speed, first one, then
// another 20 cm beside it, and it is worn: it pulls to the right, and turns late. pid.cc is yours.

#include <algorithm>
#include <cmath>
#include <memory>

#include "imr-h/robot_program.h"
#include "pid.h"

namespace {

constexpr double SPEED = 0.15;        // m/s
constexpr double FROM = 1.0;          // m, x where the first line begins
constexpr double STEP = 1.4;          // m, x where the second does
constexpr double TO = 2.6;            // m, x where it ends
constexpr double FIRST = 2.1;         // m, y of the first line
constexpr double SECOND = 2.3;        // m, y of the second
constexpr double FASTEST_TURN = 1.5;  // rad/s

class CLineKeeper : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch& sketch) override {
    if (senses.since == 0.0) {
      sketch.line(WANTED, {FROM, FIRST}, {STEP, FIRST});
      sketch.line(WANTED, {STEP, FIRST}, {STEP, SECOND});
      sketch.line(WANTED, {STEP, SECOND}, {TO, SECOND});
    }
    finished = senses.pose.x >= TO || senses.time > 60.0;
    const double line = senses.pose.x < STEP ? FIRST : SECOND;
    double wish = pid.control(line - senses.pose.y, senses.since);
    if (!std::isfinite(wish)) wish = 0.0;
    // Never back: the line is to be crossed at an angle of less than 60 degrees.
    if (std::fabs(senses.pose.yaw) > 1.0 && wish * senses.pose.yaw > 0.0) wish = 0.0;
    wish = std::clamp(wish, -FASTEST_TURN, FASTEST_TURN);
    return {ahead(senses.scan), wish};
  }
  bool done() const override { return finished; }

 private:
  static constexpr imr::CSketch::SInk WANTED = {"wanted", 255, 165, 0};

  static double ahead(const imr::SScan& scan) {
    return scan.nearestRange(-0.7, 0.7) > 0.15 ? SPEED : 0.0;
  }

  CPid pid;
  bool finished = false;
};

}  // namespace

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::CRobotProgram::addOptions(config);
  imr::SProgram about;
  about.about = "Keeps a worn robot on a line.";
  about.examples = {"", "--save line"};
  return imr::CRobotProgram::main(argc, argv, config, about, [] {
    imr::CRobotProgram::Behaviours behaviours;
    behaviours.push_back(std::make_unique<CLineKeeper>());
    return behaviours;
  });
}
