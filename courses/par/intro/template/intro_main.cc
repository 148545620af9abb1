// The program of the introduction task: drives until it is told to end. behaviour.cc is yours.

#include "behaviour.h"

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::CRobotProgram::addOptions(config);
  imr::SProgram about;
  about.about = "Drives a robot around and avoids obstacles by its laser.";
  about.examples = {"", "--seconds 60"};
  return imr::CRobotProgram::main(argc, argv, config, about, [] {
    imr::CRobotProgram::Behaviours behaviours;
    behaviours.push_back(makeBehaviour());
    return behaviours;
  });
}
