#pragma once

// The whole library in one header, for programs that run in the simulator (thesis listing C.1).

#include "libCCMorse/GridMap.h"
#include "libCCMorse/LaserProxy.h"
#include "libCCMorse/MorseActuator.h"
#include "libCCMorse/MorseAnswers.h"
#include "libCCMorse/MorseArena.h"
#include "libCCMorse/MorseClient.h"
#include "libCCMorse/MorseDevice.h"
#include "libCCMorse/MorseDriver.h"
#include "libCCMorse/MorseError.h"
#include "libCCMorse/MorseLaser.h"
#include "libCCMorse/MorseMotionVW.h"
#include "libCCMorse/MorseOdometry.h"
#include "libCCMorse/MorsePen.h"
#include "libCCMorse/MorsePose.h"
#include "libCCMorse/MorseProperties.h"
#include "libCCMorse/MorseProxy.h"
#include "libCCMorse/MorseRobot.h"
#include "libCCMorse/MorseSensor.h"
#include "libCCMorse/MorseTime.h"
#include "libCCMorse/MorseValue.h"
#include "libCCMorse/MorseWaypoint.h"
#include "libCCMorse/Paint.h"
#include "libCCMorse/PlayerClient.h"
#include "libCCMorse/Position2dProxy.h"
#include "libCCMorse/SndDriver.h"
#include "libCCMorse/Types.h"
#include "libCCMorse/WindowProxy.h"

namespace CCMorse {

/// The number that programs for the real robot define themselves (thesis listing C.1, line 10): the
/// same digits, so that a program computes the same on both.
constexpr double PI = 3.14159265359;

}  // namespace CCMorse

using CCMorse::PI;
