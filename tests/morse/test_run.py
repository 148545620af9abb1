"""Builder scripts in the simulator: `ccmorse run x.py`, read by MORSE's own Python client as Debian
packages it.

CCMORSE names the program. Needs python3-morse-simulator for pymorse.
"""

import json
import math
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from support import SCRIPTS, environment

CCMORSE = os.environ["CCMORSE"]

sys.path.append("/usr/lib/python3/dist-packages")  # Debian's, where this python3 is another one
import pymorse  # noqa: E402


class Run:
    """A simulation of a script, on free ports."""

    def __init__(self, script, *arguments, pace="real", options=()):
        self.log = tempfile.TemporaryFile("w+")
        command = [CCMORSE, "run", os.path.join(SCRIPTS, script), "--headless", "--port", "0",
                   "--stream-port", "0", "--pace", pace] + list(options)
        if arguments:
            command += ["--"] + list(arguments)
        self.process = subprocess.Popen(command, stdout=self.log, stderr=subprocess.STDOUT,
                                        env=environment(), start_new_session=True)
        until = time.monotonic() + 60.0
        while "SCENE INITIALIZED" not in self.output():
            if self.process.poll() is not None or time.monotonic() > until:
                output = self.output()
                self.close()
                raise AssertionError("no scene:\n" + output)
            time.sleep(0.02)
        self.port = int(re.search(r"MORSE services on \S+ port (\d+)", self.output()).group(1))

    def output(self):
        self.log.seek(0)
        return self.log.read()

    def close(self):
        self.stop()
        self.log.close()

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(timeout=30)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()

    def __enter__(self):
        self.morse = pymorse.Morse("127.0.0.1", self.port)
        return self

    def __exit__(self, *what):
        # pymorse's wait for publishers is broken since Python 3.8.
        self.morse.close(wait_publishers=False)
        self.close()


class Driving(unittest.TestCase):
    def test_s11_s17_a_scene_drives_and_senses(self):
        with Run("drive.py") as run:
            morse = run.morse
            self.assertEqual(morse.robots, ["robot"])
            self.assertEqual(sorted(morse.rpc("simulation", "list_streams")),
                             ["robot.motion", "robot.odometry", "robot.pose", "robot.scanner"])
            pose = morse.robot.pose.get(timeout=10)
            # 0.3 m before the robot's middle and 0.5 m above its origin, which is 0.1 m high.
            self.assertAlmostEqual(pose["x"], -4.7, places=9)
            self.assertAlmostEqual(pose["y"], 2.0, places=9)
            self.assertAlmostEqual(pose["z"], 0.6, places=9)
            scan = morse.robot.scanner.get(timeout=10)
            self.assertEqual(len(scan["range_list"]), 181)
            self.assertEqual(set(scan["range_list"]), {30.0})  # an empty world
            morse.robot.motion.publish({"v": 1.0, "w": 0.0})
            morse.sleep(1.0)
            morse.robot.motion.publish({"v": 0.0, "w": 0.0})
            morse.sleep(0.2)
            after = morse.robot.pose.get(timeout=10)
            moved = after["x"] - pose["x"]
            self.assertGreater(moved, 0.9)
            self.assertLess(moved, 1.4)
            self.assertAlmostEqual(after["y"], 2.0, places=9)
            odometry = morse.robot.odometry.get(timeout=10)
            self.assertAlmostEqual(odometry["x"], moved, places=6)
            # A quarter turn about the robot's middle takes the sensor round it.
            morse.rpc("robot.motion", "set_speed", 0.0, math.pi / 2.0)
            morse.sleep(1.0)
            morse.rpc("robot.motion", "stop")
            morse.sleep(0.2)
            turned = morse.robot.pose.get(timeout=10)
            middle = (turned["x"] - 0.3 * math.cos(turned["yaw"]),
                      turned["y"] - 0.3 * math.sin(turned["yaw"]))
            self.assertAlmostEqual(middle[0], after["x"] - 0.3, places=6)
            self.assertAlmostEqual(middle[1], 2.0, places=6)
            self.assertGreater(turned["yaw"], 1.2)
            # goto is known, as its component has services; `quiet` has neither.
            x, y = middle[0] + 1.0, middle[1] + 1.0
            self.assertEqual(morse.robot.waypoint.goto(x, y, 0.0, 0.5, 1.0).result(), "Arrived")
            with self.assertRaises(pymorse.MorseServiceFailed):
                morse.rpc("robot.quiet", "get_local_data")
            with self.assertRaises(pymorse.MorseServiceFailed):
                morse.rpc("simulation", "get_stream_port", "robot.quiet")

    def test_s10_the_default_scene(self):
        with Run("default_scene.py") as run:
            pose = run.morse.robot.pose.get(timeout=10)
            self.assertAlmostEqual(pose["x"], 1.0)
            self.assertAlmostEqual(pose["yaw"], 3.5 - 2.0 * math.pi)
            self.assertNotIn("keyboard", run.output())
            run.stop()
            self.assertEqual(run.process.returncode, 0)

    def test_names_of_components_on_what_is_not_simulated(self):
        with Run("nested_components.py") as run:
            pose = run.morse.robot.ptu.pose.get(timeout=10)
            self.assertAlmostEqual(pose["x"], 0.2)
            self.assertAlmostEqual(pose["y"], 0.5)
            self.assertAlmostEqual(pose["z"], 1.1)
            self.assertAlmostEqual(pose["yaw"], math.pi / 2.0)

    def test_h1_scanners_see_the_boxes(self):
        with Run("scanners.py") as run:
            self.assertEqual(len(run.morse.robot.hokuyo.get(timeout=10)["range_list"]), 541)
            scan = run.morse.robot.rear.get(timeout=10)
            self.assertEqual(len(scan["range_list"]), 1081)
            # The corner of the BlueBox that is nearest to the scanner, at (-3, -2.5).
            self.assertAlmostEqual(min(scan["range_list"]), math.hypot(3.0, 2.5), delta=0.03)
            # Straight behind the robot, in the middle of the fan, is the RedBox's side at x = -7.
            self.assertAlmostEqual(scan["range_list"][540], 7.0, places=9)

    def test_all_robots_stand(self):
        with Run("all_robots.py") as run:
            self.assertEqual(len(run.morse.robots), 17)
            # With and without Debian's data: a warning says what stands in.
            self.assertIn("an empty ground stands in for it", run.output())

    def test_two_cats_tutorial(self):
        with Run("cat_and_mouse.py") as run:
            self.assertAlmostEqual(run.morse.mouse.pose.get(timeout=10)["x"], 1.0)
            run.morse.cat.motion.publish({"v": 1.0, "w": 0.1})
            seen = run.morse.cat.semanticL.get(timeout=10)["visible_objects"]
            self.assertEqual([one["name"] for one in seen], ["MOUSE"])

    def test_s19_fixed_steps_do_not_wait(self):
        script = "fixed_step.py"
        result = subprocess.run(
            [CCMORSE, "run", os.path.join(SCRIPTS, script), "--headless", "--port", "0",
             "--stream-port", "0", "--for", "100"], env=environment(), stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, universal_newlines=True, timeout=60, check=False)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("pace max", result.stdout)
        self.assertIn("Simulated 100.000 s", result.stdout)

    def test_the_project_of_the_thesis(self):
        with Run(os.path.join("thesis", "default.py")) as run:
            morse = run.morse
            self.assertEqual(sorted(morse.robots), ["robot", "s1r_2"])
            self.assertEqual(len(morse.robot.hokuyo.get(timeout=10)["range_list"]), 682)
            morse.rpc("robot.pen", "set_pixel", 3, 4, 255, 0, 0)
            properties = morse.rpc("robot.robotproperties", "get_local_data")
            self.assertEqual(json.loads(properties["properties"])["canvas"]["alpha"]
                             if isinstance(properties["properties"], str) else
                             properties["properties"]["canvas"]["alpha"], 0.75)


    def test_p05_nothing_changes_the_canvass_transparency_in_a_run(self):
        with Run(os.path.join("thesis", "default.py")) as run:
            names = run.morse.rpc("simulation", "details")
            services = str([robot for robot in names["robots"] if robot["name"] == "robot"])
            self.assertIn("set_pixel", services)
            self.assertNotIn("alpha", services)
            with self.assertRaises(Exception):
                run.morse.rpc("robot.pen", "set_alpha", 0.5)
            properties = run.morse.rpc("robot.robotproperties", "get_local_data")
            self.assertIn("0.75", str(properties["properties"]))


class CommandLine(unittest.TestCase):
    def run_to_end(self, *arguments):
        return subprocess.run([CCMORSE] + list(arguments), env=environment(),
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, timeout=60, check=False)

    def script(self, name):
        return os.path.join(SCRIPTS, name)

    def test_an_error_in_the_script_ends_with_a_status(self):
        for name, line in (("error_in_the_script.py", 5), ("environment_of_nobody.py", 4)):
            result = self.run_to_end("run", self.script(name), "--port", "0")
            self.assertEqual(result.returncode, 1)
            self.assertIn("[ERROR][MORSE] ", result.stdout)
            self.assertIn("%s\", line %d" % (name, line), result.stdout)
            self.assertNotIn("SCENE INITIALIZED", result.stdout)

    def test_d_arguments_reach_the_script(self):
        result = self.run_to_end("run", self.script("arguments.py"), "--headless", "--port", "0",
                                 "--stream-port", "0", "--for", "0.1", "--pace", "max", "--", "2")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("making 2 robots", result.stdout)
        self.assertIn("2 robots", result.stdout)
        self.assertLess(result.stdout.index("making"), result.stdout.index("SCENE INITIALIZED"))

    def test_arguments_are_for_scripts_only(self):
        result = self.run_to_end("run", "syrotek", "more", "--port", "0")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("more", result.stdout)

    def test_a_script_becomes_a_scenario(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "scene.json")
            result = self.run_to_end("convert", self.script("drive.py"), "-o", file)
            self.assertEqual(result.returncode, 0, result.stdout)
            with open(file, encoding="utf-8") as text:
                scene = json.load(text)
            self.assertEqual([robot["name"] for robot in scene["robots"]], ["robot"])
            self.assertEqual(len(scene["robots"][0]["components"]), 6)
            self.assertEqual(scene["world"]["low"], [-20, -20])
            again = self.run_to_end("run", file, "--headless", "--port", "0", "--stream-port", "0",
                                    "--for", "0.1", "--pace", "max")
            self.assertEqual(again.returncode, 0, again.stdout)

    def test_a_picture_of_a_large_world(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "boxes.png")
            result = self.run_to_end("run", self.script("scanners.py"), "--headless", "--port", "0",
                                     "--stream-port", "0", "--for", "0.1", "--pace", "max",
                                     "--picture", file)
            self.assertEqual(result.returncode, 0, result.stdout)
            with open(file, "rb") as picture:
                head = picture.read(24)
            self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
            wide = int.from_bytes(head[16:20], "big")
            high = int.from_bytes(head[20:24], "big")
            self.assertAlmostEqual(wide / high, 39.1 / 30.1, delta=0.01)

    def test_every_script_that_makes_a_scene_starts(self):
        bad = {"environment_of_nobody.py", "error_in_the_script.py", "keyboard_has_no_stream.py",
               "modifier_of_nobody.py", "name_with_a_dot.py", "no_environment.py"}
        for name in sorted(os.listdir(SCRIPTS)):
            if not name.endswith(".py") or name in bad:
                continue
            with self.subTest(name):
                result = self.run_to_end("run", self.script(name), "--headless", "--port", "0",
                                         "--stream-port", "0", "--for", "0.05", "--pace", "max",
                                         "--", "2")
                self.assertEqual(result.returncode, 0, result.stdout)
                self.assertIn("EXITING SIMULATION", result.stdout)


if __name__ == "__main__":
    unittest.main()
