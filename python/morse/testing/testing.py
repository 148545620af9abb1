"""Test cases that start a simulation for each test and end it, as MORSE's users write them:

    class PoseTest(MorseTestCase):
        def setUpEnv(self):
            robot = ATRV()
            pose = Pose()
            pose.add_stream('socket')
            robot.append(pose)
            env = Environment('empty', fastmode=True)

        def test_pose(self):
            with Morse() as simu:
                self.assertAlmostEqual(simu.robot.pose.get()['x'], 0.0)

    if __name__ == "__main__":
        main(PoseTest)

main() runs them under both time strategies. The log of a class goes to CLASS.log in the current
folder. The program is $MORSE_ROOT/bin/morse, $CCMORSE, or the ccmorse or morse of PATH. With
CCMORSE_PORT=0 every simulation has ports of its own, so that tests may run at the same time;
CCMORSE_PORT=N has them use port N instead of 4000.
"""

import ast
import inspect
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import textwrap
import threading
import time
import unittest

import morse
from morse.core.morse_time import TimeStrategies
from morse.testing import pymorse_shim
from morse.testing.exceptions import MorseTestingError

_PORT = 4000
_START = 15.0  # s that a scene may take to be there
_END = 30.0  # s that a simulation may take to end
_LOOK = 0.01  # s between two looks at a log
_ERROR = "[ERROR][MORSE]"
_READY = "SCENE INITIALIZED"
_ENDED = "EXITING SIMULATION"

_STAR_IMPORTS = ("morse.builder", "morse.builder.actuators", "morse.builder.sensors",
                 "morse.builder.blenderobjects")


def find_program():
    """The simulator's command. Raises MorseTestingError."""
    root = os.environ.get("MORSE_ROOT")
    if root:
        return os.path.join(root, "bin", "morse")
    given = os.environ.get("CCMORSE")
    found = given or shutil.which("ccmorse") or shutil.which("morse")
    if not found:
        raise MorseTestingError("there is no ccmorse in PATH; CCMORSE=/path/to/ccmorse names it")
    return found


def builder_script(test_case, strategy):
    """The script that makes the scene of a test: what its setUpEnv() says, and the time strategy."""
    source = textwrap.dedent(inspect.getsource(type(test_case).setUpEnv))
    body = ast.parse(source).body[0].body
    inside = " " * body[0].col_offset
    lines = ["from %s import *" % module for module in _STAR_IMPORTS]
    lines += ["", "class MyEnv():", textwrap.indent(source.rstrip(), "    "),
              "    %senv.set_time_strategy(%s)" %
              (inside, TimeStrategies.python_repr(strategy).decode()),
              "", "MyEnv().setUpEnv()", ""]
    return "\n".join(lines)


class _Log:
    """What a simulation prints, as it comes."""

    def __init__(self, path):
        self._file = open(path, encoding="utf-8", errors="replace")
        self.text = ""
        self._lock = threading.Lock()

    def read(self):
        with self._lock:
            self.text += self._file.read()
            return self.text

    def close(self):
        self._file.close()


class MorseSwitchTimeMode(unittest.TestCase):
    """No test: what follows it runs under another time strategy."""

    def __init__(self, strategy=TimeStrategies.BestEffort):
        super().__init__("test_switch")
        self.strategy = strategy

    def test_switch(self):
        MorseTestCase.time_strategy = self.strategy

    def shortDescription(self):
        return "from here on: " + TimeStrategies.human_repr(self.strategy)


class MorseTestCase(unittest.TestCase):
    """Starts the simulation of setUpEnv() before each test and ends it after."""

    time_strategy = TimeStrategies.BestEffort  # of what is started next

    def setUpEnv(self):
        """Builds the scene, whose Environment has to be called `env`. It runs in the simulator's
        process, so it sees what a builder script sees, and nothing of the test's module."""
        raise NotImplementedError("a test of MORSE needs a setUpEnv()")

    def setUpMw(self):
        """What a middleware needs before the simulation starts."""

    def tearDownMw(self):
        """The end of setUpMw()."""

    def setUp(self):
        self.setUpMw()
        self.startmorse(self)

    def tearDown(self):
        self.stopmorse()
        self.tearDownMw()

    def run(self, result=None):
        """As every test case, but an error in the simulator ends the test, not the whole run."""
        self._failed = None
        try:
            return super().run(result)
        except KeyboardInterrupt:
            if self._failed is None:
                raise
            error = MorseTestingError("the simulator says: " + self._failed)
            if result is not None:
                result.addError(self, (MorseTestingError, error, sys.exc_info()[2]))
            self._failed = None
            self.stopmorse()
            self.tearDownMw()
            return result

    # The simulator

    def generate_builder_script(self, test_case):
        """Writes the script of a test; its path."""
        number, path = tempfile.mkstemp()
        with os.fdopen(number, "w", encoding="utf-8") as file:
            file.write(builder_script(test_case, MorseTestCase.time_strategy))
        return path

    def startmorse(self, test_case):
        """Returns when the scene is there. Raises MorseTestingError when it does not come."""
        asked = os.environ.get("CCMORSE_PORT")
        if asked is not None and not hasattr(MorseTestCase, "_asked_port"):
            MorseTestCase._asked_port = int(asked)
        port = getattr(MorseTestCase, "_asked_port", _PORT)
        self._script = self.generate_builder_script(test_case)
        self.logfile_name = type(self).__name__ + ".log"
        # Fixed steps, too, keep to real time: tests sleep by the clock.
        command = [find_program(), "run", self._script, "--headless", "--pace", "real",
                   "--port", str(port)]
        if port == 0:
            command += ["--stream-port", "0"]
        with open(self.logfile_name, "w", encoding="utf-8") as out:
            self.morse_process = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT,
                                                  stdin=subprocess.DEVNULL)
        self._log = _Log(self.logfile_name)
        try:
            self.wait_initialization()
        except BaseException:
            self._kill()
            raise

    def wait_initialization(self):
        """Waits for the scene."""
        until = time.monotonic() + _START
        while True:
            running = self.morse_process.poll() is None
            text = self._log.read()
            if _ERROR in text or "INITIALIZATION ERROR" in text or not running:
                raise MorseTestingError("no scene came of setUpEnv():\n" + text)
            if _READY in text:
                break
            if time.monotonic() > until:
                raise MorseTestingError("no scene after %g s:\n%s" % (_START, text))
            time.sleep(_LOOK)
        self.pid = int(next(line for line in text.splitlines() if "PID" in line).split()[-1])
        found = re.search(r"MORSE services on \S+ port (\d+)", text)
        self.port = int(found.group(1)) if found else _PORT
        if hasattr(MorseTestCase, "_asked_port"):
            pymorse_shim.set_port(self.port)
        self._watcher = threading.Thread(target=self._watch, daemon=True)
        self._watcher.start()

    def _watch(self):
        # Wakes the test by a signal, wherever it waits.
        seen = len(self._log.text)
        while self.morse_process.poll() is None:
            text = self._log.read()
            if _ENDED in text:
                return
            if _ERROR in text[seen:]:
                line = next(line for line in text[seen:].splitlines() if _ERROR in line)
                self._failed = line
                os.kill(os.getpid(), signal.SIGINT)
                return
            time.sleep(_LOOK)

    def stopmorse(self):
        """Asks the simulation to end, and waits until it has."""
        try:
            with socket.create_connection(("localhost", self.port), timeout=5.0) as connection:
                connection.sendall(b"id1 simulation quit\n")
        except OSError:
            self._kill()
            return
        try:
            self.morse_process.wait(_END)
        except subprocess.TimeoutExpired:
            text = self._log.read()
            self._kill()
            raise MorseTestingError("the simulation does not end:\n" + text) from None
        self._release()

    def _kill(self):
        self.morse_process.kill()
        self.morse_process.wait()
        self._release()

    def _release(self):
        watcher = getattr(self, "_watcher", None)
        if watcher is not None and watcher is not threading.current_thread():
            watcher.join()
        self._log.read()
        self._log.close()
        os.remove(self._script)


class MorseMoveTestCase(MorseTestCase):
    """Compares where `robot` is, by its sensor `pose`, and puts it there by its `teleport`."""

    _KEYS = ("x", "y", "z", "yaw", "pitch", "roll")

    def assertAlmostEqualPosition(self, morse, tested_pos, precision):
        """tested_pos: x, y, z, m, yaw, pitch, roll, rad; precision: of each."""
        pose = morse.robot.pose.get()
        for key, expected in zip(self._KEYS, tested_pos):
            self.assertAlmostEqual(pose[key], expected, delta=precision)

    def assertAlmostEqualPositionThenFix(self, morse, tested_pos, precision):
        """The same, and then the robot is exactly there; needs its `motion` and `teleport`."""
        self.assertAlmostEqualPosition(morse, tested_pos, precision)
        morse.deactivate("robot.motion")
        morse.activate("robot.teleport")
        exact = dict(zip(self._KEYS, tested_pos))
        exact["z"] += 0.01  # falls onto the ground rather than being stuck in it
        morse.robot.teleport.publish(exact)
        morse.sleep(0.1)
        morse.deactivate("robot.teleport")
        morse.activate("robot.motion")
        morse.sleep(0.1)


class MorseBuilderFailureTestCase(MorseTestCase):
    """Passes when setUpEnv() fails, with a message, and no simulation comes of it."""

    def wait_initialization(self):
        try:
            status = self.morse_process.wait(_START)
        except subprocess.TimeoutExpired:
            self.fail("a simulation came of it:\n" + self._log.read())
        text = self._log.read()
        self.assertNotIn(_READY, text)
        self.assertIn(_ERROR, text)
        self.assertNotEqual(status, 0, text)

    def stopmorse(self):
        self._release()


class MorseTestRunner(unittest.TextTestRunner):
    """unittest's own, a line for each test."""

    def __init__(self, **options):
        options.setdefault("verbosity", 2)
        super().__init__(**options)


def main(*test_cases, time_modes=(TimeStrategies.BestEffort, TimeStrategies.FixedSimulationStep)):
    """Runs the tests of all classes under each of the time strategies; ends the program with status
    1 when any has failed. In a builder script's place it makes the scene of the first class."""
    if getattr(morse, "building", False):
        test_cases[0]("setUpEnv").setUpEnv()
        return
    suite = unittest.TestSuite()
    loader = unittest.TestLoader()
    for strategy in time_modes:
        suite.addTest(MorseSwitchTimeMode(strategy))
        for test_case in test_cases:
            suite.addTest(loader.loadTestsFromTestCase(test_case))
    sys.exit(not MorseTestRunner().run(suite).wasSuccessful())
