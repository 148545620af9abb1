// Looks for what knows the robot's true place: the pose sensor, or an actuator that drives to a
// point. Where there is none (exit status 7) it says at once where it starts, which it knows, and
// drives somewhere.

#include <string>

#include "imr-h/robot_program.h"

int main(int argc, char** argv) {
  imr::CConfig config;
  imr::CRobotProgram::addOptions(config, 0);
  imr::SProgram about;
  if (!imr::parseArguments(argc, argv, config, about)) return 0;
  CCMorse::PlayerClient client(config.get<std::string>("host"), config.get<int>("port"));
  CCMorse::Position2dProxy wheels(&client, 0);
  bool found = false;
  for (const CCMorse::MorseRobot* robot : client.GetMorseClient().GetRobots()) {
    found = found || robot->FindDevice<CCMorse::MorsePose>("pose") != nullptr;
    found = found || robot->FindDevice<CCMorse::MorseWaypoint>() != nullptr;
    auto* const answers = robot->FindDevice<CCMorse::MorseAnswers>();
    if (answers != nullptr) answers->SubmitPose(0.90, 2.00, 0.0);
    for (int i = 0; i < 700; ++i) {
      client.Read();
      wheels.SetSpeed(0.1, 0.3);
    }
  }
  return found ? 0 : 7;
}
