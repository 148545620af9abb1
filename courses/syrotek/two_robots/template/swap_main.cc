// The program of the task with two robots: they change places. It drives both, over one connection;
// behaviour.cc is yours.

#include "swap.h"

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::CRobotProgram::addOptions(config);
  imr::SProgram about;
  about.about = "Has two robots change places.";
  about.examples = {"", "--save swapped"};
  return imr::CRobotProgram::main(argc, argv, config, about, [] {
    imr::CRobotProgram::Behaviours behaviours;
    behaviours.push_back(makeBehaviour({2.54, 2.40}));
    behaviours.push_back(makeBehaviour({0.70, 2.40}));
    return behaviours;
  });
}
