// The program of the trajectory task: draws the wanted trajectory in orange, and follows it in
// green. follow.cc is yours.

#include "trajectory.h"

namespace {

constexpr double ROUND = 60.0;  // s

class CFollower : public imr::CBehaviour {
 public:
  imr::SSpeed step(const imr::SSenses& senses, imr::CSketch& sketch) override {
    if (senses.since == 0.0) drawWanted(sketch);
    finished = senses.time >= ROUND - 0.0005;
    const SWanted wanted = wantedAt(senses.time);
    const imr::SPoint at = {wanted.pose.x, wanted.pose.y};
    sketch.clear(NOW);
    sketch.line(NOW, at, at);
    return follow(senses.pose, wanted);
  }
  bool done() const override { return finished; }

 private:
  static constexpr imr::CSketch::SInk WANTED = {"wanted", 255, 165, 0};
  static constexpr imr::CSketch::SInk NOW = {"wanted now", 255, 0, 0};

  static void drawWanted(imr::CSketch& sketch) {
    for (double s = 0.0; s < ROUND; s += 0.5) {
      const imr::SPose from = wantedAt(s).pose;
      const imr::SPose to = wantedAt(s + 0.5).pose;
      sketch.line(WANTED, {from.x, from.y}, {to.x, to.y});
    }
  }

  bool finished = false;
};

}  // namespace

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::CRobotProgram::addOptions(config);
  imr::SProgram about;
  about.about = "Follows a lying eight.";
  about.examples = {"", "--save followed"};
  return imr::CRobotProgram::main(argc, argv, config, about, [] {
    imr::CRobotProgram::Behaviours behaviours;
    behaviours.push_back(std::make_unique<CFollower>());
    return behaviours;
  });
}
