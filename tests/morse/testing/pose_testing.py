#! /usr/bin/env python3
"""A test as MORSE's users write them: a robot is moved, and its pose is looked at."""

import math

from morse.testing.testing import MorseTestCase

try:
    from morse.builder import *
except ImportError:
    pass

from pymorse import Morse


class PoseTest(MorseTestCase):
    def setUpEnv(self):
        robot = ATRV()
        robot.translate(10.0, 8.0, 0.0)
        robot.rotate(0.0, 0.0, math.pi / 2)

        pose = Pose()
        pose.add_stream('socket')
        pose.add_service('socket')
        robot.append(pose)

        motion = MotionVW()
        motion.add_stream('socket')
        motion.add_service('socket')
        robot.append(motion)

        env = Environment('empty', fastmode=True)
        env.add_service('socket')

    def test_pose_at_start(self):
        with Morse() as simu:
            pose = simu.robot.pose.get()
            self.assertAlmostEqual(pose['x'], 10.0, delta=1e-6)
            self.assertAlmostEqual(pose['y'], 8.0, delta=1e-6)
            self.assertAlmostEqual(pose['yaw'], math.pi / 2, delta=1e-6)

    def test_pose_after_a_drive(self):
        with Morse() as simu:
            simu.robot.motion.publish({'v': 1.0, 'w': 0.0})
            simu.sleep(1.0)
            simu.robot.motion.publish({'v': 0.0, 'w': 0.0})
            simu.sleep(0.1)
            pose = simu.robot.pose.get()
            self.assertAlmostEqual(pose['x'], 10.0, delta=1e-6)
            self.assertAlmostEqual(pose['y'], 9.0, delta=0.2)

    def test_time_mode(self):
        from morse.core.morse_time import TimeStrategies
        with Morse() as simu:
            self.assertEqual(simu.rpc('time', 'mode'),
                             TimeStrategies.human_repr(MorseTestCase.time_strategy))


if __name__ == "__main__":
    from morse.testing.testing import main
    main(PoseTest)
