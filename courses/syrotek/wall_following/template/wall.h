#pragma once

#include <memory>

#include "imr-h/robot_program.h"

/// How far the robot's middle should be from the wall on its right, m.
constexpr double WALL_DISTANCE = 0.25;

/// What behaviour.cc is to write.
std::unique_ptr<imr::CBehaviour> makeBehaviour();
