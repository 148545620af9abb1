"""30 robots with 5 sensors each at 60 Hz, all streams read by pymorse: real time with less than 60 %
of one core for the simulator.

CCMORSE names the program. Needs python3-morse-simulator for pymorse. Prints what it measures.
"""

import os
import re
import subprocess
import sys
import tempfile
import time
import unittest

from support import PYTHON, environment

CCMORSE = os.environ["CCMORSE"]
SECONDS = float(os.environ.get("CCMORSE_SECONDS", "5"))

sys.path.insert(0, PYTHON)
sys.path.append("/usr/lib/python3/dist-packages")
import morse.testing  # noqa: E402,F401  (lets pymorse close)
import pymorse  # noqa: E402

SCENE = """
from morse.builder import *
for i in range(30):
    robot = ATRV()
    robot.name = 'r%02d' % i
    robot.translate(x=2.0 * (i % 6) - 5.0, y=2.0 * (i // 6) - 4.0)
    for make, name in ((Pose, 'pose'), (Odometry, 'odometry'), (Gyroscope, 'gyroscope'),
                       (Velocity, 'velocity'), (Accelerometer, 'accelerometer')):
        sensor = make(name)
        sensor.frequency(60)
        robot.append(sensor)
    motion = MotionVW('motion')
    robot.append(motion)
    robot.add_default_interface('socket')
env = Environment('empty', fastmode=True)
"""


def cpu_seconds(pid):
    with open("/proc/%d/stat" % pid, encoding="ascii") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Numbers(unittest.TestCase):
    def test_30_robots_with_5_sensors_at_60_hz_are_read_by_pymorse(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.py")
            with open(scene, "w", encoding="utf-8") as file:
                file.write(SCENE)
            with open(os.path.join(folder, "log"), "w+", encoding="utf-8") as log:
                run = subprocess.Popen(
                    [CCMORSE, "run", scene, "--headless", "--port", "0", "--stream-port", "0"],
                    env=environment(), stdout=log, stderr=subprocess.STDOUT)
                try:
                    until = time.monotonic() + 30.0
                    text = ""
                    while "SCENE INITIALIZED" not in text and time.monotonic() < until:
                        time.sleep(0.05)
                        log.seek(0)
                        text = log.read()
                    port = int(re.search(r"MORSE services on \S+ port (\d+)", text).group(1))
                    self.measure(run.pid, port)
                finally:
                    run.terminate()
                    run.wait(30)

    def measure(self, pid, port):
        with pymorse.Morse("localhost", port) as simu:
            counts = {}
            for name in simu.robots:
                robot = getattr(simu, name)
                robot.motion.publish({"v": 0.2, "w": 0.5})
                for sensor in ("pose", "odometry", "gyroscope", "velocity", "accelerometer"):
                    key = name + "." + sensor
                    counts[key] = 0

                    def count(data, key=key):
                        counts[key] += 1

                    getattr(robot, sensor).lazy_init()
                    getattr(robot, sensor).subscribe(count)
            self.assertEqual(len(counts), 150)
            simu.sleep(1.0)
            before = dict(counts)
            cpu, wall, simulated = cpu_seconds(pid), time.monotonic(), simu.time()
            time.sleep(SECONDS)
            passed = simu.time() - simulated
            wall = time.monotonic() - wall
            used = (cpu_seconds(pid) - cpu) / wall
            lines = sum(counts.values()) - sum(before.values())
        print("30 robots, 150 streams at 60 Hz: %.1f %% of one core, %.3f simulated s a second, "
              "%.0f of 9000 lines/s read by pymorse" % (100.0 * used, passed / wall, lines / wall))
        self.assertLess(used, 0.6)
        self.assertAlmostEqual(passed / wall, 1.0, delta=0.1)
        self.assertTrue(all(counts[key] > before[key] for key in counts))


if __name__ == "__main__":
    unittest.main()
