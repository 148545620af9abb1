// The program of the wall following task. behaviour.cc is yours.

#include "wall.h"

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::CRobotProgram::addOptions(config);
  imr::SProgram about;
  about.about = "Follows the wall on the right.";
  about.examples = {"", "--seconds 60"};
  return imr::CRobotProgram::main(argc, argv, config, about, [] {
    imr::CRobotProgram::Behaviours behaviours;
    behaviours.push_back(makeBehaviour());
    return behaviours;
  });
}
