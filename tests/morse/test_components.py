"""Sensors and actuators of builder scripts in the simulator, read by pymorse: numbers from the
physics of robots that go as they are told.

CCMORSE names the program. Needs python3-morse-simulator for pymorse.
"""

import math
import unittest

from test_run import Run, pymorse


def read(run, name):
    """What a sensor shows by its service."""
    return run.morse.rpc(name, "get_local_data")


class Motion(unittest.TestCase):
    def test_b2_sensors_of_a_robot_on_a_circle(self):
        with Run("sensors_of_motion.py") as run:
            morse = run.morse
            morse.rpc("robot.motion", "set_speed", 1.0, 0.5)
            morse.sleep(1.0)
            for name in ("velocity", "position"):
                velocity = read(run, "robot." + name)
                self.assertAlmostEqual(velocity["linear_velocity"][0], 1.0, delta=1e-3)
                self.assertAlmostEqual(velocity["linear_velocity"][1], 0.0, delta=0.01)
                self.assertAlmostEqual(velocity["angular_velocity"][2], 0.5, delta=1e-9)
                self.assertAlmostEqual(math.hypot(*velocity["world_linear_velocity"][:2]), 1.0,
                                       delta=1e-3)
            felt = read(run, "robot.accelerometer")
            self.assertAlmostEqual(felt["acceleration"][0], 0.0, delta=0.01)
            self.assertAlmostEqual(felt["acceleration"][1], 1.0 * 0.5, delta=0.01)
            self.assertAlmostEqual(felt["distance"], 1.0 / 60.0, delta=1e-4)
            self.assertAlmostEqual(read(run, "robot.airspeed")["diff_pressure"], 0.5 * 1.225,
                                   delta=1e-9)
            self.assertAlmostEqual(read(run, "robot.raw")["dS"], 1.0 / 60.0, delta=1e-4)
            step = read(run, "robot.differential")
            self.assertAlmostEqual(math.hypot(step["dx"], step["dy"]), 0.1, delta=1e-3)
            self.assertAlmostEqual(step["dyaw"], 0.05, delta=1e-9)
            morse.rpc("robot.motion", "stop")
            morse.sleep(0.2)
            attitude = read(run, "robot.attitude")
            self.assertGreater(attitude["rotation"]["yaw"], math.pi / 2.0 + 0.49)
            self.assertAlmostEqual(read(run, "robot.gyroscope")["yaw"],
                                   attitude["rotation"]["yaw"] + 0.5, places=9)
            self.assertEqual(list(read(run, "robot.clock")), ["timestamp"])
            self.assertEqual(set(morse.robot.clock.get(timeout=10)), {"timestamp"})

    def test_a5_set_property(self):
        with Run("sensors_of_motion.py") as run:
            morse = run.morse
            properties = morse.rpc("robot.position", "get_properties")["properties"]
            self.assertEqual(properties["ComputationMode"][0], "Position")
            morse.rpc("robot.position", "set_property", "ComputationMode", "Velocity")
            configurations = morse.rpc("robot.position", "get_configurations")["configurations"]
            self.assertEqual(configurations["ComputationMode"], "Velocity")
            self.assertEqual(configurations["object_to_robot"]["translation"], [0.0, 0.0, 0.0])
            with self.assertRaisesRegex(pymorse.MorseServiceFailed,
                                        "Property Colour does not exist for object robot.position"):
                morse.rpc("robot.position", "set_property", "Colour", "red")
            with self.assertRaisesRegex(pymorse.MorseServiceFailed, "wrong parameter type"):
                morse.rpc("robot.position", "set_property", "ComputationMode", 3)


class World(unittest.TestCase):
    def test_b2_sensors_of_the_world_around(self):
        with Run("sensors_of_the_world.py") as run:
            morse = run.morse
            morse.sleep(0.5)
            gps = read(run, "robot.gps")
            self.assertAlmostEqual(gps["x"], 0.5, places=9)
            self.assertAlmostEqual(gps["z"], 0.5, places=9)
            earth = read(run, "robot.earth")
            self.assertAlmostEqual(earth["longitude"], 1.5, places=10)
            self.assertAlmostEqual(earth["latitude"], 43.6, places=10)
            self.assertAlmostEqual(earth["altitude"], 150.1, places=6)
            self.assertNotIn("heading", earth)
            extended = read(run, "robot.extended")
            self.assertEqual(extended["date"], "010170")
            self.assertEqual(extended["heading"], math.inf)
            self.assertAlmostEqual(read(run, "robot.barometer")["pressure"], 101325.0, places=6)
            self.assertAlmostEqual(read(run, "robot.thermometer")["temperature"],
                                   15.0 + 300.0 * math.exp(-0.2 * 5.0), places=9)
            self.assertAlmostEqual(read(run, "robot.altimeter")["z"], 2.1, places=6)
            near = read(run, "robot.proximity")
            self.assertAlmostEqual(near["near_objects"]["mouse"], 5.0, places=9)
            self.assertEqual(near["near_objects"], near["near_robots"])
            morse.rpc("robot.proximity", "set_range", 4.9)
            morse.sleep(0.3)
            self.assertEqual(read(run, "robot.proximity")["near_objects"], {})

    def test_b2_a_battery_and_b3_teleport(self):
        with Run("sensors_of_the_world.py") as run:
            morse = run.morse
            morse.sleep(1.0)
            battery = read(run, "robot.battery")
            self.assertEqual(battery["status"], "Discharging")
            self.assertAlmostEqual(battery["charge"], 100.0 - 10.0 * battery["timestamp"],
                                   places=6)
            morse.rpc("robot.teleport", "translate", -10.0)
            morse.sleep(0.2)
            self.assertAlmostEqual(read(run, "robot.gps")["x"], -9.5, places=9)
            self.assertIn(read(run, "robot.battery")["status"], ("Charging", "Charged"))

    def test_b2_a_collision_and_b3_xyw(self):
        with Run("sensors_of_the_world.py") as run:
            morse = run.morse
            morse.deactivate("robot.teleport")
            self.assertIs(read(run, "robot.collision")["collision"], False)
            morse.robot.motion.publish({"x": 3.0, "y": 4.0, "w": 0.0})
            # Nothing comes of it until it touches the other.
            told = morse.robot.collision.get(timeout=20)
            self.assertIs(told["collision"], True)
            self.assertEqual(told["objects"], "mouse")


class Actuators(unittest.TestCase):
    def test_b3_destination_of_what_flies(self):
        with Run("actuators.py") as run:
            run.morse.flyer.destination.publish({"x": 3.0, "y": 4.0, "z": 5.0})
            run.morse.sleep(3.5)
            pose = read(run, "flyer.pose")
            self.assertAlmostEqual(math.hypot(pose["x"] - 3.0, pose["y"] - 4.0), 0.0, delta=0.06)
            self.assertAlmostEqual(pose["z"], 5.0, places=9)

    def test_b3_two_wheels_and_orientation(self):
        with Run("actuators.py") as run:
            run.morse.turner.orientation.publish({"yaw": 2.0, "pitch": 0.0, "roll": 0.0})
            run.morse.sleep(0.5)
            self.assertAlmostEqual(read(run, "turner.heading")["yaw"], 2.0, places=9)
            self.assertIsNone(run.morse.rpc("robot.motion", "set_speed", 0.5, 0.1))
            self.assertIsNone(run.morse.rpc("robot.motion", "stop"))
            run.morse.robot.sound.publish({"mode": "play"})

    def test_b3_light_and_waypoint(self):
        with Run("actuators.py") as run:
            morse = run.morse
            self.assertIs(morse.rpc("robot.light", "toggle"), True)
            self.assertIs(morse.rpc("robot.light", "toggle", False), True)
            properties = morse.rpc("turner.waypoint", "get_properties")["properties"]
            self.assertAlmostEqual(properties["AngleTolerance"][0], math.radians(10.0))
            morse.rpc("turner.waypoint", "set_property", "RemainAtDestination", True)
            self.assertEqual(morse.rpc("turner.waypoint", "get_status"), "Stop")


if __name__ == "__main__":
    unittest.main()
