"""What builder scripts ask for, in the simulator and under both of MORSE's time strategies, read by
pymorse: numbers from the physics of robots that go as they are told.

A script runs as morse.testing runs it: with a line behind it that chooses the strategy, and here
also one that lets simulated time go FAST times as fast. CCMORSE names the program. Needs
python3-morse-simulator for pymorse.
"""

import math
import os
import shutil
import tempfile
import time
import unittest

import test_components
import test_run
from support import SCRIPTS

STRATEGIES = {"BestEffort": "Best Effort", "FixedSimulationStep": "Fixed Simulation Step"}
FAST = 5
BEHIND = """

from morse.builder.environment import Environment as _Environment
from morse.core.morse_time import TimeStrategies as _TimeStrategies
_Environment.current.set_time_strategy(_TimeStrategies.%s)
_Environment.current.set_time_scale(accelerate_by=%d)
"""


class Run(test_run.Run):
    """A script of scripts/, or a project's default.py there, with its time as a test wants it."""

    def __init__(self, script, strategy, fast=FAST):
        self.folder = tempfile.mkdtemp()
        self.strategy = strategy
        folder, name = os.path.split(script)
        copy = os.path.join(self.folder, name)
        if folder:  # a project with folders beside the script
            shutil.copytree(os.path.join(SCRIPTS, folder), os.path.join(self.folder, folder))
            copy = os.path.join(self.folder, script)
        with open(os.path.join(SCRIPTS, script), encoding="utf-8") as file:
            text = file.read()
        with open(copy, "w", encoding="utf-8") as file:
            file.write(text + BEHIND % (strategy, fast))
        super().__init__(copy)

    def __enter__(self):
        super().__enter__()
        mode = self.morse.rpc("time", "mode")
        if mode != STRATEGIES[self.strategy]:
            self.__exit__()
            raise AssertionError("the simulation's mode is %s" % mode)
        return self

    def close(self):
        super().close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def read(self, name):
        """What a sensor shows by its service."""
        return self.morse.rpc(name, "get_local_data")

    def drive(self, name, v, w, seconds):
        """Has a MotionVW drive for so many simulated seconds, however slow this machine is."""
        ticks = round(self.hello()["frequency"] * seconds)
        self.morse.rpc("ccmorse", "pause")
        self.morse.rpc(name, "set_speed", v, w)
        self.morse.rpc("ccmorse", "step", ticks)
        self.morse.rpc(name, "stop")
        self.morse.rpc("ccmorse", "step", 6)
        self.morse.rpc("ccmorse", "resume")

    def hello(self):
        """What the program says of itself."""
        return self.morse.rpc("ccmorse", "hello", {})


class BestEffort(unittest.TestCase):
    strategy = "BestEffort"

    def run_script(self, script, fast=FAST):
        return Run(script, self.strategy, fast)

    def near(self, given, expected, delta=1e-9):
        self.assertEqual(len(given), len(expected))
        for a, b in zip(given, expected):
            self.assertAlmostEqual(a, b, delta=delta)

    def test_c5_components_act_at_their_rates(self):
        with self.run_script("rates.py", 2) as run:
            robot, lines = run.morse.robot, {}
            for name in ("every", "third", "uneven", "slow"):
                lines[name] = []
                getattr(robot, name).subscribe(
                    lambda data, told=lines[name]: told.append(data["timestamp"]))
            run.morse.sleep(3.0)
            ends = {name: list(told) for name, told in lines.items()}
            for name, rate in (("every", 60.0), ("third", 20.0), ("slow", 4.0)):
                times = ends[name]
                self.assertGreater(len(times), 1.5 * rate, name)
                self.assertLess(len(times), 4.0 * rate, name)
                for before, after in zip(times, times[1:]):
                    # A line may be missed by a reader that is late; never is one too many.
                    steps = (after - before) * rate
                    self.assertAlmostEqual(steps, round(steps), delta=1e-6)
                    self.assertGreater(steps, 0.5)
            # 25 Hz of 60: every second or third tick, 25 in a second.
            ticks = [round((after - before) * 60.0)
                     for before, after in zip(ends["uneven"], ends["uneven"][1:])]
            self.assertLessEqual({one for one in ticks if one < 4}, {2, 3})
            told = ends["uneven"]
            self.assertAlmostEqual((len(told) - 1) / (told[-1] - told[0]), 25.0, delta=1.0)

    def test_c5_the_fastest_component_tunes_the_simulation(self):
        tuned = 120.0 if self.strategy == "BestEffort" else 60.0  # a fixed step stays
        with self.run_script("fast_component.py") as run:
            self.assertEqual(run.hello()["frequency"], tuned)
            first = run.morse.robot.pose.get(timeout=10)
            then = run.morse.robot.pose.get(timeout=10)
            steps = (then["timestamp"] - first["timestamp"]) * tuned
            self.assertAlmostEqual(steps, round(steps), delta=1e-6)
            self.assertLess(steps, 60.0)

    def test_c6_robots_made_in_a_loop_are_a_list(self):
        with self.run_script("group.py") as run:
            self.assertEqual(sorted(run.morse.robots), ["rover", "rover_001", "rover_002"])
            self.assertEqual(len(run.morse.rovers), 3)
            for number, name in enumerate(("rover", "rover_001", "rover_002")):
                before = run.read(name + ".pose")
                self.near([before[key] for key in ("x", "y", "yaw")],
                          [2.0, 4.0 * number, 0.5 * number])
                run.drive(name + ".motion", 1.0, 0.0, 0.5)
                after = run.read(name + ".pose")
                moved = math.hypot(after["x"] - before["x"], after["y"] - before["y"])
                self.assertAlmostEqual(moved, 0.5, delta=0.05)
                self.near([after["x"], after["y"]],
                          [before["x"] + moved * math.cos(0.5 * number),
                           before["y"] + moved * math.sin(0.5 * number)], 1e-6)

    def test_c6_names_of_constructors_setters_and_clashes(self):
        with self.run_script("names.py") as run:
            self.assertEqual(sorted(run.morse.robots), ["given", "renamed", "third"])
            for number, name in enumerate(("renamed", "given", "third")):
                for part in ("spot", "spot_001"):
                    self.assertAlmostEqual(run.read("%s.%s" % (name, part))["y"], 5.0 * number)

    def test_c1_components_on_turned_components(self):
        with self.run_script("mounts.py") as run:
            eye = run.read("robot.turret.eye")
            # The robot looks along y, the turret 0.5 m ahead of it along -x; the eye is 0.2 m
            # ahead of the turret and 0.1 m to its left.
            self.near([eye[key] for key in ("x", "y", "z")], [1.0 - 0.2, 2.0 + 0.5 - 0.1, 1.1])
            self.assertAlmostEqual(abs(eye["yaw"]), math.pi)
            self.assertAlmostEqual(eye["pitch"], 0.3)
            beside = run.read("robot.beside")
            self.near([beside[key] for key in ("x", "y", "z", "roll")], [1.3, 2.0, 0.5, 0.1])
            run.drive("robot.motion", 0.0, 1.0, 1.0)
            turned = run.read("robot.beside")
            yaw = turned["yaw"]
            self.assertAlmostEqual(yaw, math.pi / 2.0 + 1.0, delta=0.1)
            self.near([turned["x"], turned["y"]],
                      [1.0 + 0.3 * math.sin(yaw), 2.0 - 0.3 * math.cos(yaw)], 1e-6)

    def test_c3_the_default_interface(self):
        with self.run_script("default_interface.py") as run:
            details = {name: known for robot in run.morse.rpc("simulation", "details")["robots"]
                       for name, known in robot["components"].items()}
            streamed = sorted(name for name, known in details.items()
                              if "stream_interfaces" in known)
            self.assertEqual(streamed, ["robot.gps", "robot.pose"])
            self.assertEqual(sorted(run.morse.rpc("simulation", "list_streams")), streamed)
            ports = run.morse.rpc("simulation", "get_all_stream_ports")
            self.assertEqual(len(set(ports.values())), 2)
            served = sorted(name for name, known in details.items() if "services" in known)
            # A keyboard is moved by the view, which calls a service of it.
            self.assertEqual(served, ["other.served", "robot.gps", "robot.keyboard", "robot.pose"])
            self.assertAlmostEqual(run.read("other.served")["x"], 5.0)

    def test_c1_properties_of_components_and_robots(self):
        with self.run_script("component_properties.py") as run:
            self.assertAlmostEqual(run.read("robot.barometer")["pressure"], 90000.0, places=6)
            self.assertAlmostEqual(run.read("robot.thermometer")["temperature"],
                                   -5.0 + 100.0 * math.exp(-0.5 * 5.0), places=6)
            near = run.read("robot.proximity")["near_objects"]
            self.assertEqual(list(near), ["near"])  # far is 8 m away, other has no such property
            self.assertAlmostEqual(near["near"], 5.0, places=6)
            properties = run.morse.rpc("robot.waypoint", "get_properties")["properties"]
            self.assertEqual((properties["Speed"][0], properties["RemainAtDestination"][0]),
                             (2.0, True))

    def test_c3_a_ghost_is_neither_seen_nor_touched(self):
        with self.run_script("ghosts.py") as run:
            ranges = run.read("robot.sick")["range_list"]
            self.assertAlmostEqual(ranges[90], 8.0 - 0.267, delta=0.01)  # beside the ghost
            self.assertEqual(ranges[97], 20.0)  # where it stands
            run.drive("robot.motion", 4.0, 0.0, 2.5)
            pose = run.read("robot.pose")
            # Through the ghost and up to the B21, round and 0.534 m wide.
            self.assertAlmostEqual(pose["x"], 8.0 - 0.267 - 0.57, delta=0.05)

    def test_b6_shapes_are_no_obstacles(self):
        with self.run_script("shapes_are_no_obstacles.py") as run:
            self.assertEqual(set(run.read("robot.sick")["range_list"]), {30.0})
            run.drive("robot.motion", 2.0, 0.0, 2.0)
            self.assertAlmostEqual(run.read("robot.pose")["x"], 4.0, delta=0.2)

    def test_b6_a_battery_is_charged_in_its_zone(self):
        with self.run_script("charging.py") as run:
            run.morse.sleep(1.0)
            battery = run.read("robot.battery")
            self.assertEqual(battery["status"], "Discharging")
            self.assertAlmostEqual(battery["charge"], 100.0 - 20.0 * battery["timestamp"],
                                   delta=0.5)
            run.drive("robot.motion", 2.0, 0.0, 2.0)
            self.near([run.read("robot.pose")["x"]], [4.0], 0.2)
            first = run.read("robot.battery")
            self.assertEqual(first["status"], "Charging")
            run.morse.sleep(0.5)
            then = run.read("robot.battery")
            self.assertAlmostEqual(then["charge"] - first["charge"],
                                   20.0 * (then["timestamp"] - first["timestamp"]), delta=0.5)

    def test_c1_levels_of_an_odometry_agree(self):
        with self.run_script("odometries.py", 2) as run:
            robot = run.morse.robot
            told = {"raw": {}, "differential": {}}
            robot.raw.subscribe(lambda data: told["raw"].update({data["timestamp"]: data["dS"]}))
            robot.differential.subscribe(
                lambda data: told["differential"].update({data["timestamp"]: data["dyaw"]}))
            run.morse.sleep(0.2)
            run.drive("robot.motion", 1.0, 0.5, 1.5)
            end = run.read("robot.integrated")
            pose = run.read("robot.pose")
            # In the frame of the start, which lies at (-3, 1) and is turned by 1 rad.
            x, y = pose["x"] + 3.0, pose["y"] - 1.0
            self.near([end["x"], end["y"], end["yaw"]],
                      [x * math.cos(1.0) + y * math.sin(1.0),
                       y * math.cos(1.0) - x * math.sin(1.0), pose["yaw"] - 1.0], 1e-6)
            # An arc of radius 2 m.
            self.near([end["x"], end["y"]],
                      [2.0 * math.sin(end["yaw"]), 2.0 - 2.0 * math.cos(end["yaw"])], 0.01)
            moving = [path for path in told["raw"].values() if path > 1e-3]
            self.assertGreater(len(moving), 30)  # of 90; a slow reader misses some
            for path in moving[5:-5]:
                self.assertAlmostEqual(path, 1.0 / 60.0, delta=1e-3)
            turning = [turn for turn in told["differential"].values() if turn > 1e-4]
            for turn in turning[5:-5]:
                self.assertAlmostEqual(turn, 0.5 / 60.0, delta=1e-4)

    def test_c7_what_is_set_in_blender_s_own_objects(self):
        with self.run_script("reaching_into_blender.py") as run:
            pose = run.read("robot.pose")
            self.near([pose[key] for key in ("x", "y", "z", "yaw")], [1.0, 2.0, 3.25, 0.5], 1e-6)
            self.assertAlmostEqual(run.read("robot.proximity")["near_objects"]["other"], 5.0,
                                   places=6)

    def test_a10_distances_and_views_between_robots(self):
        with self.run_script("distances.py") as run:
            def ask(one, other):
                return run.morse.rpc("communication", "distance_and_view", one, other)

            self.near([ask("seer", "seen")[0], ask("seer", "hidden")[0], ask("seer", "aside")[0]],
                      [6.0, 12.0, 8.0])
            self.assertEqual([ask("seer", "seen")[1], ask("seer", "hidden")[1],
                              ask("seer", "aside")[1]], [True, False, True])

    def test_c3_robots_of_ones_own_package(self):
        with self.run_script(os.path.join("own_robots", "default.py")) as run:
            self.assertEqual(sorted(run.morse.robots), ["alpha", "beta"])
            self.assertAlmostEqual(run.read("beta.pose")["z"], 0.6, places=6)
            for name, reach in (("alpha", 12.0), ("beta", 4.0)):
                ranges = run.read(name + ".scanner")["range_list"]
                self.assertEqual((len(ranges), max(ranges)), (91, reach))
            # They drive past one another, 9 m apart; alpha's 90 degrees are too few to see beta.
            run.drive("beta.motion", 2.0, 0.0, 1.0)
            pose = run.read("beta.pose")
            self.assertAlmostEqual(pose["x"], 1.0 - 2.0, delta=0.1)
            self.assertAlmostEqual(pose["y"], 9.0, places=6)

    def test_b3_every_robot_of_a_loop_reaches_its_own_point(self):
        with self.run_script("robots_in_a_loop.py") as run:
            going = [run.morse.rpc_t(20, "patrol%d.motion" % number, "setdest", 3.0 * number, 1.0,
                                     0.0, 0.3, 2.0) for number in range(4)]
            self.assertEqual(going, [True] * 4)
            run.morse.sleep(4.0)
            for number in range(4):
                pose = run.read("patrol%d.pose" % number)
                self.assertLess(math.hypot(pose["x"] - 3.0 * number, pose["y"] - 1.0), 0.4)
                self.assertEqual(run.morse.rpc("patrol%d.motion" % number, "get_status"),
                                 "Arrived")

    def test_c4_time_is_scaled(self):
        with self.run_script("drive.py", 10) as run:
            begin, wall = run.morse.rpc("time", "now"), time.monotonic()
            run.morse.sleep(6.0)
            took = time.monotonic() - wall
            self.assertGreater(run.morse.rpc("time", "now") - begin, 5.9)
            self.assertLess(took, 5.0)  # 0.6 s, and a busy machine
            self.assertGreater(took, 0.5)


class FixedSimulationStep(BestEffort):
    strategy = "FixedSimulationStep"


def _of_fixed_steps(case):
    """A class of test_components.py, whose scripts run as they are there, with fixed steps."""
    class Fixed(case):
        def setUp(self):
            super().setUp()
            known = test_components.Run
            test_components.Run = lambda script, **_: Run(script, "FixedSimulationStep",
                                                              1)
            self.addCleanup(setattr, test_components, "Run", known)

    Fixed.__name__ = Fixed.__qualname__ = "FixedSteps" + case.__name__
    return Fixed


for _name, _case in list(vars(test_components).items()):
    if isinstance(_case, type) and issubclass(_case, unittest.TestCase):
        globals()["FixedSteps" + _name] = _of_fixed_steps(_case)
del _case


if __name__ == "__main__":
    unittest.main()
