// The course's robot, built for the real robot (without _MORSE), over the stand-in library, which
// has no window then.
#include <gtest/gtest.h>

#include "courses/par/intro/solutions/thesis/robot.h"
#include "tests/course/robot_fixture.h"

#ifdef _MORSE
#error "this test is about the program without _MORSE"
#endif

namespace {

using Strings = std::vector<std::string>;

class X09 : public course::RobotTest {};
class B05 : public course::RobotTest {};

}  // namespace

TEST_F(X09, ServerDefaultsForTheRealRobot) {
  EXPECT_EQ(config_.get<std::string>("host"), "syrotek.felk.cvut.cz");
  EXPECT_EQ(config_.getDescription<std::string>("host"), "syrotek server hostname");
  EXPECT_EQ(config_.get<int>("port"), 38000);
  EXPECT_EQ(config_.getDescription<int>("port"), "syrotek server port");
  EXPECT_EQ(course::Dump(config_),
            "host=syrotek.felk.cvut.cz\nport=38000\nlaser-index=0\nposition2d-index=0\n"
            "coords=false\nx=0\ny=0\nyaw=0\n");
}

TEST(B08, ProgramDefinesPiItself) { EXPECT_EQ(PI, 3.14159265359); }

TEST_F(B05, TheSameProgramDrivesWithoutAWindow) {
  world_.on_read = [&](long read) {
    world_.BringAll();
    world_.time = static_cast<double>(read);
  };
  Drive(1.0);
  EXPECT_EQ(world_.Calls(),
            (Strings{"new PlayerClient", "connect syrotek.felk.cvut.cz:38000", "new LaserProxy",
                     "laser index 0", "new Position2dProxy", "position2d index 0", "motors on",
                     "speed 0.300000 0.000000", "speed 0.300000 0.000000", "motors off",
                     "delete LaserProxy", "delete Position2dProxy", "delete PlayerClient"}));
  EXPECT_EQ(summary_.scans, 2u);
}
