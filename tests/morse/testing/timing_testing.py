#! /usr/bin/env python3
"""What MORSE's own tests take for granted of time (specs: morse.md E.6)."""

import time

from morse.testing.testing import MorseMoveTestCase, main

try:
    from morse.builder import *
except ImportError:
    pass

import pymorse
from pymorse import Morse


class TimingTest(MorseMoveTestCase):
    def setUpEnv(self):
        robot = ATRV()

        pose = Pose()
        pose.add_stream('socket')
        robot.append(pose)

        accelerometer = Accelerometer()
        accelerometer.add_stream('socket')
        robot.append(accelerometer)

        motion = MotionVW()
        motion.add_stream('socket')
        motion.add_service('socket')
        robot.append(motion)

        teleport = Teleport()
        teleport.add_stream('socket')
        robot.append(teleport)

        waypoint = Waypoint()
        waypoint.add_stream('socket')
        waypoint.add_service('socket')
        robot.append(waypoint)

        env = Environment('empty', fastmode=True)
        env.add_service('socket')

    def test_the_one_line_with_a_spike_is_got_after_a_sleep(self):
        with Morse() as simu:
            simu.deactivate('robot.teleport')
            accelerometer, motion = simu.robot.accelerometer, simu.robot.motion
            spikes = 0
            for speed in (1.0, 0.0) * 10:
                motion.publish({'v': speed, 'w': 0.0})
                simu.sleep(0.01)
                spikes += abs(accelerometer.get()['acceleration'][0]) > 50.0
                simu.sleep(0.1)
            # A client that is held up for 4 ms is too late; without them hardly one would be seen.
            self.assertGreaterEqual(spikes, 10)

    def test_one_tick_is_enough_to_be_elsewhere(self):
        with Morse() as simu:
            simu.deactivate('robot.motion')
            pose, teleport = simu.robot.pose, simu.robot.teleport
            for i in range(20):
                x, y = 1.0 + i, -1.0 - 0.5 * i
                teleport.publish({'x': x, 'y': y, 'z': 0.1, 'yaw': 0.0, 'pitch': 0.0, 'roll': 0.0})
                simu.sleep(0.01)
                got = pose.get()
                self.assertAlmostEqual(got['x'], x, delta=1e-6)
                self.assertAlmostEqual(got['y'], y, delta=1e-6)

    def test_what_one_sensor_gets_is_the_last_of_another(self):
        with Morse() as simu:
            # pymorse looks at connections in the order in which they were made.
            accelerometer, pose = simu.robot.accelerometer, simu.robot.pose
            for _ in range(30):
                # Back to back, by name: the pose's line comes last.
                got = pose.get()
                self.assertEqual(accelerometer.last()['timestamp'], got['timestamp'])

    def test_a_cancelled_goto_is_preempted_within_a_tenth_of_a_second(self):
        with Morse() as simu:
            simu.deactivate('robot.teleport')
            going = simu.robot.waypoint.goto(15.0, 0.0, 0.0, 0.5, 0.5)
            simu.sleep(0.2)
            self.assertTrue(going.running())
            going.cancel()
            time.sleep(0.1)
            self.assertTrue(going.done())
            with self.assertRaises(pymorse.MorseServicePreempted):
                going.result()

    def test_simulated_time_keeps_to_the_clock(self):
        with Morse() as simu:
            simu.sleep(0.1)
            start, clock = simu.time(), time.monotonic()
            time.sleep(1.0)
            self.assertAlmostEqual(simu.time() - start, time.monotonic() - clock, delta=0.2)

    def test_a_position_is_fixed(self):
        with Morse() as simu:
            simu.sleep(0.1)
            self.assertAlmostEqualPositionThenFix(simu, [0.0, 0.0, 0.1, 0.0, 0.0, 0.0], 0.1)


if __name__ == "__main__":
    main(TimingTest)
