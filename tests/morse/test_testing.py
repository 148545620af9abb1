"""morse.testing and the shim for pymorse: users' tests of MORSE run, and tell what is wrong.

CCMORSE names the program. Needs python3-morse-simulator for pymorse.
"""

import os
import re
import socket
import subprocess
import sys
import tempfile
import textwrap
import time
import unittest

from support import HERE, PYTHON, environment

CCMORSE = os.environ["CCMORSE"]
TESTS = os.path.join(HERE, "testing")
DEBIAN = "/usr/lib/python3/dist-packages"  # where pymorse lies, for another python3 than Debian's

sys.path.insert(0, PYTHON)
from morse.core.morse_time import TimeStrategies  # noqa: E402
from morse.testing import pymorse_shim  # noqa: E402
from morse.testing.testing import MorseTestCase, builder_script  # noqa: E402


def run_tests(name, folder, *arguments, **variables):
    """A file of tests run as its user does, each simulation on ports of its own."""
    variables.setdefault("CCMORSE", CCMORSE)
    return subprocess.run(
        [sys.executable, "-B", os.path.join(TESTS, name)] + list(arguments), cwd=folder,
        env=environment(PYTHONPATH=PYTHON + ":" + DEBIAN, CCMORSE_PORT="0", **variables),
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, timeout=300,
        check=False)


class Users(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def test_e2_a_users_tests_run_under_both_time_strategies(self):
        result = run_tests("pose_testing.py", self.folder.name)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertRegex(result.stdout, r"Ran 8 tests")  # 3 twice, and 2 changes of strategy
        for name in ("test_pose_at_start", "test_pose_after_a_drive", "test_time_mode"):
            self.assertEqual(len(re.findall(name + r" .*\.\.\. ok", result.stdout)), 2)
        with open(os.path.join(self.folder.name, "PoseTest.log"), encoding="utf-8") as log:
            text = log.read()
        pid = next(line for line in text.splitlines() if "PID" in line)
        self.assertRegex(pid, r"PID: \d+$")
        self.assertIn("SCENE INITIALIZED", text)
        self.assertIn("EXITING SIMULATION", text)

    def test_e6_timing_holds(self):
        result = run_tests("timing_testing.py", self.folder.name)
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_e2_a_scene_that_cannot_be_is_a_test(self):
        result = run_tests("failure_testing.py", self.folder.name)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertRegex(result.stdout, r"Ran 6 tests")
        with open(os.path.join(self.folder.name, "NoEnvironment.log"), encoding="utf-8") as log:
            text = log.read()
        self.assertIn("[ERROR][MORSE]", text)
        self.assertNotIn("Blender Game Engine Started", text)

    def test_what_fails_is_told(self):
        result = run_tests("wrong_testing.py", self.folder.name)
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertRegex(result.stdout, r"test_wrong .*\.\.\. FAIL")
        self.assertRegex(result.stdout, r"test_initialization .*\.\.\. FAIL")
        self.assertRegex(result.stdout, r"test_nothing .*\.\.\. ERROR")
        self.assertIn("[ERROR][MORSE]", result.stdout)  # why, from the log

    def test_e2_a_file_of_tests_can_be_run_as_a_scene(self):
        result = subprocess.run(
            [CCMORSE, "run", os.path.join(TESTS, "pose_testing.py"), "--headless", "--port", "0",
             "--stream-port", "0", "--for", "0.1", "--pace", "max"],
            env=environment(PYTHONPATH=PYTHON + ":" + DEBIAN), stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, universal_newlines=True, timeout=60, check=False)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("SCENE INITIALIZED", result.stdout)
        self.assertIn("1 robot", result.stdout)


class StandIn(unittest.TestCase):
    """A program in the simulator's place, that does what ours would not."""

    def run_with(self, program):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "stand-in")
            with open(path, "w", encoding="utf-8") as file:
                file.write("#!%s\n%s" % (sys.executable, textwrap.dedent(program)))
            os.chmod(path, 0o755)
            started = time.monotonic()
            result = run_tests("pose_testing.py", folder, CCMORSE=path)
            self.assertLess(time.monotonic() - started, 120.0)
            return result

    def test_e2_an_error_in_the_run_ends_the_test(self):
        result = self.run_with("""
            import sys, time
            print("PID: 1\\nMORSE services on 127.0.0.1 port 1\\nSCENE INITIALIZED", flush=True)
            print("[ERROR][MORSE] it is broken", flush=True)
            time.sleep(60)
            """)
        self.assertEqual(result.returncode, 1)
        self.assertIn("it is broken", result.stdout)

    def test_a_program_that_ends_is_not_waited_for(self):
        result = self.run_with("print('no licence')\n")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no licence", result.stdout)


class Script(unittest.TestCase):
    def test_e2_the_script_of_a_test(self):
        class Deep(MorseTestCase):
            def setUpEnv(self):
                robot = ATRV()  # noqa: F821
                if robot:
                    env = Environment('empty')  # noqa: F821

            def runTest(self):
                pass

        text = builder_script(Deep(), TimeStrategies.FixedSimulationStep)
        self.assertEqual(text, textwrap.dedent("""\
            from morse.builder import *
            from morse.builder.actuators import *
            from morse.builder.sensors import *
            from morse.builder.blenderobjects import *

            class MyEnv():
                def setUpEnv(self):
                    robot = ATRV()  # noqa: F821
                    if robot:
                        env = Environment('empty')  # noqa: F821
                    env.set_time_strategy(TimeStrategies.FixedSimulationStep)

            MyEnv().setUpEnv()
            """))
        compile(text, "script", "exec")

    def test_e2_time_strategies(self):
        self.assertEqual((TimeStrategies.BestEffort, TimeStrategies.FixedSimulationStep), (0, 1))
        self.assertEqual(TimeStrategies.python_repr(0), b"TimeStrategies.BestEffort")
        self.assertEqual(TimeStrategies.human_repr(1), "Fixed Simulation Step")


CLIENT = """
import sys
{before}
import pymorse
with pymorse.Morse("localhost", int(sys.argv[1])) as simu:
    simu.robot.motion.publish({{"v": 0.5, "w": 0.0}})
    x = simu.robot.pose.get()["x"]
    simu.sleep(0.2)
    assert simu.robot.pose.get()["x"] > x
    assert simu.robot.goal.goto(20.0, 0.0, 0.0) is not None
    simu.cancel(simu.simulator_service_id - 1)
    seen = []
    simu.robot.pose.subscribe(seen.append)
    simu.sleep(0.5)
    assert len(seen) > 20, seen
print("all well")
"""

SCENE = """
from morse.builder import *
robot = ATRV()
for make, name in ((Pose, 'pose'), (MotionVW, 'motion'), (Waypoint, 'goal')):
    component = make(name)
    robot.append(component)
robot.add_default_interface('socket')
env = Environment('empty', fastmode=True)
"""


class Shim(unittest.TestCase):
    """specs: morse.md E.3"""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        scene = self.write("scene.py", SCENE)
        self.simulator = subprocess.Popen(
            [CCMORSE, "run", scene, "--headless", "--port", "0", "--stream-port", "0"],
            env=environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            universal_newlines=True)
        self.port = None
        for line in self.simulator.stdout:
            found = re.search(r"MORSE services on \S+ port (\d+)", line)
            if found:
                self.port = found.group(1)
            if "SCENE INITIALIZED" in line:
                break
        self.assertIsNotNone(self.port)

    def tearDown(self):
        self.simulator.terminate()
        self.simulator.communicate(timeout=30)
        self.folder.cleanup()

    def write(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def client(self, path, before=""):
        script = self.write("client.py", CLIENT.format(before=before))
        return subprocess.run(
            [sys.executable, "-B", script, self.port], env=environment(PYTHONPATH=path),
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, timeout=60,
            check=False)

    def folder_of_the_command(self):
        result = subprocess.run([CCMORSE, "pymorse-shim"], stdout=subprocess.PIPE,
                                universal_newlines=True, timeout=60, check=True)
        return result.stdout.strip()

    def test_e3_debians_own_pymorse_closes_with_the_commands_folder(self):
        result = self.client(self.folder_of_the_command() + ":" + DEBIAN)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("all well", result.stdout)

    def test_e3_importing_morse_testing_is_enough(self):
        result = self.client(PYTHON + ":" + DEBIAN, "import morse.testing.testing")
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_e3_it_may_come_after_pymorse(self):
        result = self.client(PYTHON + ":" + DEBIAN, "import pymorse\nimport morse.testing")
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_e3_it_brings_what_python_3_12_has_no_more(self):
        removed = os.path.join(os.path.dirname(pymorse_shim.__file__), "removed")
        result = self.client(self.folder_of_the_command() + ":" + removed + ":" + DEBIAN,
                             "import asyncore\nassert 'removed' in asyncore.__file__")
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_e3_another_sitecustomize_is_loaded_as_well(self):
        self.write("sitecustomize.py", "print('and me')")
        result = self.client(":".join([self.folder_of_the_command(), self.folder.name, DEBIAN]))
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("and me", result.stdout)

    def test_e3_programs_without_pymorse_are_as_ever(self):
        result = subprocess.run(
            [sys.executable, "-B", "-c", "import sys; print('pymorse' in sys.modules)"],
            env=environment(PYTHONPATH=self.folder_of_the_command()), stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, universal_newlines=True, timeout=60, check=True)
        self.assertEqual(result.stdout, "False\n")


def lines_until(process, text):
    """What a process prints, up to a line with this text."""
    lines = []
    for line in process.stdout:
        lines.append(line)
        if text in line:
            return lines
    raise AssertionError("no '%s' in\n%s" % (text, "".join(lines)))


class Together(unittest.TestCase):
    """What a script asks for of several nodes and of a client that gives the time."""

    def start(self, *arguments):
        process = subprocess.Popen([CCMORSE] + list(arguments), env=environment(),
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   universal_newlines=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait, 30)
        self.addCleanup(process.kill)
        return process

    def test_a7_a_script_on_one_node_and_on_two_has_the_same_hash(self):
        server = self.start("multinode-server", "--port", "0")
        port = lines_until(server, "Multinode server")[-1].split()[-1]
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.py")
            with open(scene, "w", encoding="utf-8") as file:
                file.write(textwrap.dedent("""
                    from morse.builder import *
                    one, two = ATRV(), Morsy()
                    two.translate(x=3.0)
                    for robot in (one, two):
                        pose = Pose()
                        pose.alter('Noise')
                        robot.append(pose)
                        sick = Sick()
                        robot.append(sick)
                        robot.add_default_interface('socket')
                    env = Environment('empty', fastmode=True)
                    env.configure_multinode(protocol='socket', server_address='localhost',
                                            server_port='%s',
                                            distribution={'A': ['one'], 'B': ['two']})
                    """ % port))
            common = ["run", scene, "--headless", "--port", "0", "--stream-port", "0", "--pace",
                      "max", "--for", "3"]
            alone = self.start(*common).communicate(timeout=60)[0]
            self.assertIn("all robots are on this one", alone)
            nodes = [self.start(*(common + ["--name", name])) for name in "AB"]
            hashes = [re.search(r"state hash +(\w+)", node.communicate(timeout=60)[0]).group(1)
                      for node in nodes]
            self.assertEqual(hashes, [re.search(r"state hash +(\w+)", alone).group(1)] * 2)

    def test_a6_a_script_has_its_port_of_time_synchronisation(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.py")
            with open(scene, "w", encoding="utf-8") as file:
                file.write(SCENE + "env.configure_stream_manager('socket', time_sync=True)\n")
            run = self.start("run", scene, "--headless", "--port", "0", "--stream-port", "0")
            text = "".join(lines_until(run, "SCENE INITIALIZED"))
        port = int(re.search(r"Time synchronisation on \S+ port (\d+)", text).group(1))
        services = int(re.search(r"MORSE services on \S+ port (\d+)", text).group(1))
        with socket.create_connection(("localhost", services), 10) as client:
            replies = client.makefile()

            def tick():
                client.sendall(b"1 ccmorse time\n")
                return int(re.search(r'"tick": (\d+)', replies.readline()).group(1))

            with socket.create_connection(("localhost", port), 10) as master:
                before = tick()
                while True:  # until it is seen that there is a client
                    time.sleep(0.1)
                    now = tick()
                    if now == before:
                        break
                    before = now
                for i in range(1, 6):
                    master.sendall(b"sync")
                    until = time.monotonic() + 10.0
                    while tick() < before + i and time.monotonic() < until:
                        time.sleep(0.001)
                    time.sleep(0.05)
                    self.assertEqual(tick(), before + i)


if __name__ == "__main__":
    unittest.main()
