"""Robots of builder scripts that forces move, read by pymorse: numbers from mechanics with MORSE's
constants, under both time strategies.

CCMORSE names the program. Needs python3-morse-simulator for pymorse.
"""

import math
import os
import re
import subprocess
import tempfile
import unittest

from support import SCRIPTS, environment
from test_run import CCMORSE, Run

G = 9.81  # m/s^2


def both(test):
    """Under BestEffort and under FixedSimulationStep."""
    def run(self):
        for arguments in ((), ("fixed",)):
            with self.subTest(strategy=arguments or "best effort"):
                test(self, arguments)
    run.__name__, run.__doc__ = test.__name__, test.__doc__
    return run


def gain(before, after):
    """m/s^2, upwards, between two lines of a Velocity; and the mean of the speeds, m/s."""
    first, last = (line["world_linear_velocity"][2] for line in (before, after))
    return (last - first) / (after["timestamp"] - before["timestamp"]), 0.5 * (first + last)


def read(run, name):
    """What a sensor shows by its service."""
    return run.morse.rpc(name, "get_local_data")


class Dynamics(unittest.TestCase):
    @both
    def test_b3_force_torque(self, arguments):
        with Run("force_torque.py", *arguments) as run:
            run.morse.robot.push.publish({"force": [0.0, 0.0, 20.0 * G + 10.0],
                                          "torque": [0.0, 0.0, 0.0]})
            run.morse.sleep(0.5)
            before = read(run, "robot.velocity")
            run.morse.sleep(1.0)
            gained, speed = gain(before, read(run, "robot.velocity"))
            # 10 N on 20 kg, less what its damping of 0.0254 takes.
            self.assertAlmostEqual(gained, 0.5 + math.log(1.0 - 0.0254) * speed, delta=0.02)

    @both
    def test_b3_external_force_is_in_the_worlds_frame(self, arguments):
        with Run("external_force.py", *arguments) as run:
            run.morse.robot.wind.publish({"force": [2.0, 0.0, 0.0], "torque": [0.0, 0.0, 0.0]})
            run.morse.sleep(1.5)
            velocity = read(run, "robot.velocity")["world_linear_velocity"]
            self.assertGreater(velocity[0], 1.5)
            self.assertAlmostEqual(velocity[1], 0.0, places=6)
            self.assertAlmostEqual(read(run, "robot.pose")["z"], 10.0, places=6)

    @both
    def test_b3_drag_has_a_terminal_velocity(self, arguments):
        with Run("drag.py", *arguments) as run:
            run.morse.sleep(4.0)
            speed = -read(run, "robot.velocity")["world_linear_velocity"][2]
            # c v^2 = m g, and a little of damping: 2 kg, 2 N s^2/m^2.
            self.assertAlmostEqual(speed, math.sqrt(2.0 * G / 2.0), delta=0.05)

    @both
    def test_h2_friction_and_damping(self, arguments):
        with Run("friction.py", *arguments) as run:
            morse = run.morse
            morse.rpc("robot.motion", "set_speed", 1.0, 0.0)
            morse.rpc("morsy.drive", "set_speed", 2.0, 0.0)
            morse.sleep(0.5)
            before = read(run, "robot.pose")
            morse.sleep(2.0)
            after = read(run, "robot.pose")
            passed = after["timestamp"] - before["timestamp"]
            self.assertAlmostEqual((after["x"] - before["x"]) / passed, 0.7, delta=0.05)
            self.assertAlmostEqual(read(run, "morsy.airspeed")["diff_pressure"], 2.30, delta=0.01)

    @both
    def test_b3_wheels(self, arguments):
        with Run("wheels.py", *arguments) as run:
            morse = run.morse
            morse.rpc("robot.motion", "set_speed", 0.4, 0.0)
            morse.rpc("segway.drive", "set_speed", 0.5, 0.0)
            morse.sleep(1.0)
            for name, v in (("robot.pose", 0.4), ("segway.place", 0.5)):
                before = read(run, name)
                morse.sleep(2.0)
                after = read(run, name)
                passed = after["timestamp"] - before["timestamp"]
                self.assertAlmostEqual((after["x"] - before["x"]) / passed, v, delta=0.05)
            morse.rpc("robot.motion", "stop")
            morse.sleep(1.0)
            stood = read(run, "robot.pose")["x"]
            morse.sleep(0.5)
            self.assertAlmostEqual(read(run, "robot.pose")["x"], stood, delta=0.01)

    @both
    def test_b3_steer_force(self, arguments):
        with Run("steer_force.py", *arguments) as run:
            run.morse.sleep(1.0)
            run.morse.robot.car.publish({"steer": 0.0, "force": -10.0, "brake": 0.0})
            run.morse.sleep(8.0)
            # 1.6 m/s^2 against a damping of 0.4.
            self.assertAlmostEqual(read(run, "robot.velocity")["linear_velocity"][0],
                                   1.6 / -math.log(0.6), delta=0.25)
            run.morse.robot.car.publish({"steer": 0.0, "force": 0.0, "brake": 20.0})
            run.morse.sleep(3.0)
            self.assertAlmostEqual(read(run, "robot.velocity")["linear_velocity"][0], 0.0,
                                   delta=0.05)

    @both
    def test_b3_rotorcraft_attitude(self, arguments):
        with Run("rotorcraft_attitude.py", *arguments) as run:
            hover = {"roll": 0.0, "pitch": 0.0, "yaw": 0.0, "thrust": 2.0 * G / 40.0}
            run.morse.robot.attitude.publish(hover)
            run.morse.sleep(1.0)
            run.morse.robot.attitude.publish(dict(hover, pitch=-0.1, roll=0.05))
            run.morse.sleep(1.0)
            pose = read(run, "robot.pose")
            self.assertAlmostEqual(pose["pitch"], 0.1, delta=0.01)
            self.assertAlmostEqual(pose["roll"], 0.05, delta=0.01)
            self.assertGreater(read(run, "robot.velocity")["world_linear_velocity"][0], 0.4)

    @both
    def test_b3_rotorcraft_velocity(self, arguments):
        with Run("rotorcraft_velocity.py", *arguments) as run:
            run.morse.sleep(0.5)
            self.assertAlmostEqual(read(run, "robot.pose")["z"], 10.0, delta=0.05)
            run.morse.rpc("robot.flight", "setvel", 0.0, 0.0, 1.0, 0.5)
            run.morse.sleep(4.0)
            velocity = read(run, "robot.velocity")
            self.assertAlmostEqual(velocity["world_linear_velocity"][2], 1.0, delta=0.1)
            self.assertAlmostEqual(velocity["angular_velocity"][2], 0.5, delta=0.05)

    @both
    def test_b3_rotorcraft_waypoint(self, arguments):
        with Run("rotorcraft_waypoint.py", *arguments) as run:
            self.assertEqual(run.morse.rpc("robot.waypoint", "get_status"), "Stop")
            goal = run.morse.robot.waypoint.goto(2.0, 1.0, 4.0, 0.5, 0.2)
            self.assertEqual(goal.result(), "Arrived")
            pose = read(run, "robot.pose")
            self.assertLess(math.dist((pose["x"], pose["y"], pose["z"]), (2.0, 1.0, 4.0)), 0.3)

    @both
    def test_b3_stabilized_quadrotor(self, arguments):
        with Run("stabilized_quadrotor.py", *arguments) as run:
            self.assertIsNone(run.morse.rpc("robot.flight", "set_cons", 0.0, 0.0, 0.0, 5.0))
            run.morse.sleep(4.0)
            self.assertAlmostEqual(read(run, "robot.pose")["z"], 5.0, delta=0.01)
            run.morse.rpc("robot.flight", "set_cons", 0.0, 0.05, 0.0, 5.0)
            run.morse.sleep(1.0)
            pose = read(run, "robot.pose")
            self.assertAlmostEqual(pose["pitch"], 0.05, delta=0.005)
            self.assertGreater(pose["x"], 0.05)

    @both
    def test_b3_quadrotor_dynamic_control_on_the_moon(self, arguments):
        with Run("quadrotor_dynamic_control.py", *arguments) as run:
            speed = math.sqrt(2.0 * (1.62 + 0.5) / (4.0 * 9.169e-06))
            run.morse.robot.rotors.publish({"engines": [speed] * 4})
            run.morse.sleep(0.5)
            before = read(run, "robot.velocity")
            run.morse.sleep(1.0)
            gained, speed = gain(before, read(run, "robot.velocity"))
            self.assertAlmostEqual(gained, 0.5 + math.log(1.0 - 0.04) * speed, delta=0.02)

    @both
    def test_b4_a_submarine_hovers_and_is_pushed(self, arguments):
        with Run("submarine.py", *arguments) as run:
            run.morse.sleep(0.5)
            self.assertAlmostEqual(read(run, "robot.pose")["z"], 10.0, places=6)
            run.morse.robot.push.publish({"force": [1.0, 0.0, 0.0], "torque": [0.0, 0.0, 0.0]})
            run.morse.sleep(1.5)
            self.assertGreater(read(run, "robot.velocity")["world_linear_velocity"][0], 1.0)
            self.assertAlmostEqual(read(run, "robot.pose")["z"], 10.0, places=6)

    @both
    def test_b2_collision(self, arguments):
        with Run("collision_dynamic.py", *arguments) as run:
            self.assertIs(read(run, "robot.collision")["collision"], False)
            run.morse.rpc("robot.motion", "set_speed", 1.0, 0.0)
            told = run.morse.robot.collision.get(timeout=20)
            self.assertIs(told["collision"], True)
            self.assertEqual(told["objects"], "other")
            # Half of its own length and of the other's before it.
            run.morse.sleep(1.0)
            self.assertAlmostEqual(read(run, "robot.pose")["x"],
                                   3.0 - 0.5 * (1.14 + 0.787), delta=0.05)


class Promises(unittest.TestCase):
    def test_a_record_with_pushes_in_it_is_simulated_again_to_the_same_bits(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "pushes.mcap")
            with Run("force_torque.py", options=("--record", file)) as run:
                for push in ([30.0, 5.0, 150.0], [-30.0, 0.0, 250.0]):
                    run.morse.robot.push.publish({"force": push, "torque": [0.5, 0.2, 1.0]})
                    run.morse.sleep(0.7)
            told = subprocess.run([CCMORSE, "replay", file, "--verify"], env=environment(),
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                  timeout=60, check=False)
            self.assertEqual(told.returncode, 0, told.stdout)
            self.assertIn("equal", told.stdout)

    def test_two_runs_have_one_hash(self):
        for script in ("drag.py", "wheels.py", "rotorcraft_velocity.py", "steer_force.py"):
            hashes = set()
            for _ in range(2):
                told = subprocess.run(
                    [CCMORSE, "run", os.path.join(SCRIPTS, script), "--headless", "--port", "0",
                     "--stream-port", "0", "--pace", "max", "--for", "5"], env=environment(),
                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60,
                    check=False)
                self.assertEqual(told.returncode, 0, told.stdout)
                hashes.add(re.search(r"state hash +(\w+)", told.stdout).group(1))
            self.assertEqual(len(hashes), 1, script)


if __name__ == "__main__":
    unittest.main()
