"""Sensors, actuators and modifiers of what is felt, carried, found and said in other coordinates:
builder scripts in the simulator, read by pymorse, with numbers of calculations of their own.

Each test runs under both time strategies. CCMORSE names the program. Needs python3-morse-simulator
for pymorse.
"""

import math
import os
import unittest

from support import environment
from test_run import Run, pymorse

# MORSE's ellipsoid (specs: morse.md B.5).
A, E2 = 6378137.0, 8.181919191e-2 ** 2
LONGITUDE, LATITUDE, ALTITUDE = math.radians(1.5), math.radians(43.6), 150.0


def read(run, name):
    """What a component shows by its service."""
    return run.morse.rpc(name, "get_local_data")


def both(test):
    """The test in real time, and as fast as it goes: best effort and fixed steps."""
    def run_both(self):
        for pace in ("real", "max"):
            with self.subTest(pace=pace):
                test(self, pace)
    run_both.__name__ = test.__name__
    return run_both


def earth_from_geodetic(longitude, latitude, altitude):
    """m from the Earth's centre; rad and m."""
    normal = A / math.sqrt(1.0 - E2 * math.sin(latitude) ** 2)
    return ((normal + altitude) * math.cos(latitude) * math.cos(longitude),
            (normal + altitude) * math.cos(latitude) * math.sin(longitude),
            (normal * (1.0 - E2) + altitude) * math.sin(latitude))


def earth_from_world(east, north, up):
    """m from the Earth's centre, of a place of the scripts' world."""
    x, y, z = earth_from_geodetic(LONGITUDE, LATITUDE, ALTITUDE)
    sl, cl, sb, cb = (math.sin(LONGITUDE), math.cos(LONGITUDE), math.sin(LATITUDE),
                      math.cos(LATITUDE))
    return (x - sl * east - sb * cl * north + cb * cl * up,
            y + cl * east - sb * sl * north + cb * sl * up,
            z + cb * north + sb * up)


class Felt(unittest.TestCase):
    @both
    def test_b2_magnetometer_and_imu(self, pace):
        with Run("magnetic_sensors.py", pace=pace) as run:
            run.morse.sleep(0.3)
            field = read(run, "robot.magnetometer")
            # In the south of France it is about 47 uT, mostly downwards, nearly northwards.
            strength = math.hypot(*(field[axis] for axis in "xyz"))
            full = (os.path.exists("/usr/share/morse/data/WMM.COF") and
                    environment().get("CCMORSE_MORSE_DATA") != "off")
            self.assertGreater(strength, 44e3 if full else 35e3)
            self.assertLess(strength, 50e3)
            self.assertGreater(field["z"], 0.7 * strength)
            # The robot is turned by 0.5 rad, and a level field is where x would be north.
            level = math.hypot(field["x"], field["y"])
            declination = math.atan2(field["y"], field["x"]) + 0.5
            self.assertLess(abs(declination), math.radians(4.0 if full else 15.0))
            self.assertLess(level, 30e3)
            self.assertEqual(run.morse.rpc("robot.in_2017", "get_properties")
                             ["properties"]["date"][0], 2017.5)
            self.assertNotEqual(read(run, "robot.in_2017")["x"], field["x"])
            imu = run.morse.robot.imu.get(timeout=10)
            for axis, part in zip("xyz", imu["magnetic_field"]):
                self.assertAlmostEqual(part, field[axis], delta=0.01)  # 0.3 m higher
            self.assertAlmostEqual(imu["linear_acceleration"][2], 9.81, places=9)
            run.morse.rpc("robot.motion", "set_speed", 1.0, 0.5)
            run.morse.sleep(0.5)
            imu = run.morse.robot.imu.get(timeout=10)
            self.assertAlmostEqual(imu["angular_velocity"][2], 0.5, places=9)
            self.assertAlmostEqual(imu["linear_acceleration"][1], 1.0 * 0.5, delta=0.01)
            noisy = read(run, "robot.noisy")
            self.assertNotEqual(noisy["angular_velocity"][0], 0.0)
            self.assertLess(abs(noisy["angular_velocity"][0]), 0.08)


class Modifiers(unittest.TestCase):
    @both
    def test_b5_sensors_in_other_coordinates(self, pace):
        with Run("modifiers.py", pace=pace) as run:
            run.morse.sleep(0.2)
            pose = read(run, "robot.pose")
            ned = read(run, "robot.ned")
            self.assertEqual((ned["x"], ned["y"], ned["z"]), (pose["y"], pose["x"], -pose["z"]))
            earth = earth_from_world(3.0, -4.0, pose["z"])
            ecef = read(run, "robot.ecef")
            for axis, expected in zip("xyz", earth):
                self.assertAlmostEqual(ecef[axis], expected, delta=1e-6)
            geodetic = read(run, "robot.geodetic")
            back = earth_from_geodetic(math.radians(geodetic["x"]), math.radians(geodetic["y"]),
                                       geodetic["z"])
            for got, expected in zip(back, earth):
                self.assertAlmostEqual(got, expected, delta=1e-6)
            centric = read(run, "robot.geocentric")
            self.assertAlmostEqual(centric["z"], math.hypot(*earth), delta=1e-6)
            self.assertAlmostEqual(centric["y"], math.degrees(math.asin(earth[2] /
                                                                        math.hypot(*earth))))
            utm = read(run, "robot.utm")
            self.assertEqual((utm["x"], utm["y"]), (123453.0, 4799996.0))
            self.assertAlmostEqual(read(run, "robot.feet")["x"], 3.0 * 3.2808399)
            self.assertAlmostEqual(read(run, "robot.gyroscope")["roll"], math.pi / 2.0)

    @both
    def test_b5_noise(self, pace):
        with Run("modifiers.py", pace=pace) as run:
            run.morse.sleep(0.1)
            off = []
            for _ in range(100):
                noisy = run.morse.robot.noisy.get(timeout=10)
                off.append(noisy["x"] - 3.0)
                self.assertAlmostEqual(noisy["z"], 0.1, places=9)
                self.assertLess(abs(noisy["roll"]), 0.12)
            self.assertLess(abs(sum(off) / len(off)), 0.08)
            deviation = math.sqrt(sum(one * one for one in off) / len(off))
            self.assertTrue(0.13 < deviation < 0.27, deviation)

    @both
    def test_b5_actuators_in_other_coordinates(self, pace):
        with Run("modifiers.py", pace=pace) as run:
            run.morse.north.teleport.publish({"x": 7.0, "y": -6.0, "z": 0.0, "yaw": 0.0,
                                              "pitch": 0.0, "roll": 0.0})
            run.morse.far.destination.publish({"x": 123450.0 - 8.0, "y": 4800000.0 + 2.0,
                                               "z": 0.1})
            run.morse.sleep(2.0)
            place = read(run, "north.place")
            self.assertAlmostEqual(place["x"], -6.0, places=9)
            self.assertAlmostEqual(place["y"], 7.0, places=9)
            where = read(run, "far.where")
            self.assertLess(math.hypot(where["x"] + 8.0, where["y"] - 2.0), 0.06)

    @both
    def test_b5_odometry_noise(self, pace):
        with Run("odometry_noise.py", pace=pace) as run:
            run.morse.rpc("robot.motion", "set_speed", 0.5, 0.0)
            run.morse.sleep(1.0)
            self.assertAlmostEqual(read(run, "robot.raw")["dS"], 0.5 * 0.5 / 60.0, places=9)
            self.assertAlmostEqual(read(run, "robot.odometry")["vx"], 0.6, places=9)
            run.morse.rpc("robot.motion", "stop")
            run.morse.sleep(0.2)
            truth = read(run, "robot.truth")["x"]
            self.assertAlmostEqual(read(run, "robot.odometry")["x"], 1.2 * truth, places=6)
            run.morse.rpc("robot.odometry", "reset_noise")
            run.morse.sleep(0.2)
            self.assertAlmostEqual(read(run, "robot.odometry")["x"], truth, places=9)
            self.assertNotEqual(read(run, "robot.shaky")["y"], 0.0)


class Carried(unittest.TestCase):
    @both
    def test_b3_ptu_and_b2_posture(self, pace):
        with Run("pan_tilt.py", pace=pace) as run:
            ptu = run.morse.robot.ptu
            self.assertIsNone(ptu.set_pan_tilt(1.0, -0.2).result(timeout=30))
            pan, tilt = run.morse.rpc("robot.ptu", "get_pan_tilt")
            self.assertAlmostEqual(pan, 1.0, delta=0.01)
            run.morse.sleep(0.2)
            posture = read(run, "robot.ptu.posture")
            self.assertAlmostEqual(posture["pan"], pan, places=9)
            self.assertAlmostEqual(posture["tilt"], tilt, places=9)
            gyroscope = read(run, "robot.ptu.gyroscope")
            self.assertAlmostEqual(gyroscope["yaw"], pan, places=9)
            self.assertAlmostEqual(gyroscope["pitch"], tilt, places=9)
            eye = read(run, "robot.ptu.eye")
            self.assertAlmostEqual(eye["x"], 0.2 + 0.1 * math.cos(pan) * math.cos(tilt), places=9)
            self.assertAlmostEqual(eye["y"], 0.1 * math.sin(pan) * math.cos(tilt), places=9)
            self.assertIsNone(ptu.look_at_object("mouse").result(timeout=30))
            pan, tilt = run.morse.rpc("robot.ptu", "get_pan_tilt")
            self.assertAlmostEqual(pan, math.atan2(3.0, 3.8), delta=0.011)
            run.morse.sleep(0.3)
            ahead = read(run, "robot.ptu.sick")["range_list"][90]
            self.assertLess(ahead, math.hypot(3.8, 3.0))
            self.assertIsNone(ptu.look_at_point(0.2, 5.0, 1.0).result(timeout=30))
            self.assertAlmostEqual(run.morse.rpc("robot.ptu", "get_pan_tilt")[0], math.pi / 2.0,
                                   delta=0.011)
            with self.assertRaises(pymorse.MorseServiceFailed):
                ptu.look_at_object("cheese").result(timeout=30)

    @both
    def test_b3_gripper(self, pace):
        with Run("gripper.py", pace=pace) as run:
            morse = run.morse
            self.assertIsNone(morse.rpc("robot.hand", "release"))
            self.assertEqual(morse.rpc("robot.hand", "grab"), "cup")
            self.assertEqual(morse.rpc("robot.hand", "grab"), "cup")
            morse.rpc("robot.teleport", "translate", 5.0)
            morse.sleep(0.3)
            self.assertAlmostEqual(read(run, "robot.proximity")["near_objects"]["cup"], 1.5,
                                   places=6)
            self.assertIs(morse.rpc("robot.hand", "release"), True)
            morse.rpc("robot.teleport", "translate", -3.0)
            morse.sleep(0.3)
            self.assertAlmostEqual(read(run, "robot.proximity")["near_objects"]["cup"], 4.5,
                                   places=6)
            self.assertIsNone(morse.rpc("robot.hand", "grab"))

    @both
    def test_b3_arucomarker(self, pace):
        with Run("arucomarker.py", pace=pace) as run:
            run.morse.robot.marker.publish({"x": 1.0, "y": 2.0, "z": 3.0, "roll": 0.0,
                                            "pitch": 0.0, "yaw": 0.0})
            run.morse.sleep(0.2)
            x, y, z = run.morse.rpc("robot.marker", "get_world_position")
            self.assertAlmostEqual(x, 1.0 + 3.0 + 0.5)
            self.assertAlmostEqual(y, 2.0 + 1.0)
            self.assertAlmostEqual(z, 0.1 - 2.0 + 1.0)

    @both
    def test_b3_keyboard(self, pace):
        with Run("keyboard.py", pace=pace) as run:
            # As the view's keys do it.
            run.morse.rpc("robot.keyboard", "drive", 1.0, 0.0)
            run.morse.sleep(0.3)
            self.assertAlmostEqual(read(run, "robot.velocity")["linear_velocity"][0], 2.0)
            run.morse.rpc("robot.keyboard", "drive", 0.0, 0.0)
            run.morse.sleep(0.2)
            self.assertEqual(read(run, "robot.velocity")["linear_velocity"][0], 0.0)


class Found(unittest.TestCase):
    @both
    def test_b2_search_and_rescue(self, pace):
        with Run("search_and_rescue.py", pace=pace) as run:
            run.morse.sleep(0.5)
            seen = read(run, "robot.rescuer")["victim_dict"]
            self.assertEqual(set(seen), {"victim", "one_of_three"})
            self.assertEqual(seen["victim"]["requirements"], [1, 2, 3])
            self.assertEqual(seen["one_of_three"]["severity"], 3)
            self.assertAlmostEqual(seen["victim"]["coordinate"]["x"], 2.5)
            self.assertEqual(run.morse.rpc("robot.rescuer", "get_robot_abilities"), [1, 2, 3])
            self.assertEqual(run.morse.rpc("robot.rescuer", "get_victim_severity"), 10)
            before = run.morse.time()
            self.assertEqual(run.morse.rpc("robot.rescuer", "heal"), "Victim 'victim' healed")
            self.assertGreater(run.morse.time() - before, 9.0 / 6.0)
            run.morse.sleep(0.6)
            self.assertEqual(set(read(run, "robot.rescuer")["victim_dict"]), {"one_of_three"})
            with self.assertRaises(pymorse.MorseServiceFailed):
                run.morse.rpc("robot.rescuer", "heal")

    @both
    def test_b2_semantic_camera(self, pace):
        with Run("semantic_camera.py", pace=pace) as run:
            run.morse.sleep(0.3)
            seen = read(run, "robot.camera")["visible_objects"]
            self.assertEqual([one["name"] for one in seen], ["MOUSE"])
            self.assertEqual((seen[0]["type"], seen[0]["description"]), ("Animal", "grey"))
            self.assertAlmostEqual(seen[0]["position"][0], 6.0)
            self.assertEqual(seen[0]["orientation"], {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0})
            seen = run.morse.robot.relative.get(timeout=10)["visible_objects"]
            self.assertEqual([one["name"] for one in seen], ["behind_it", "MOUSE"])
            self.assertAlmostEqual(seen[1]["position"][0], 5.3)
            # Turned away, it sees nothing.
            run.morse.rpc("robot.teleport", "rotate", 0.0, 0.0, math.pi)
            run.morse.sleep(0.3)
            self.assertEqual(read(run, "robot.relative")["visible_objects"], [])

    @both
    def test_b2_compound_sensor(self, pace):
        with Run("compound_sensor.py", pace=pace) as run:
            data = run.morse.robot.everything.get(timeout=10)
            self.assertEqual(set(data), {"timestamp", "robot.pose", "robot.gyroscope"})
            self.assertEqual(set(data["robot.gyroscope"]), {"timestamp", "yaw", "pitch", "roll"})

    @both
    def test_b2_velodyne_ray_cast(self, pace):
        with Run("velodyne_ray_cast.py", pace=pace) as run:
            run.morse.sleep(0.3)
            ranges = read(run, "robot.velodyne")["range_list"]
            self.assertEqual(len(ranges), 64)
            for beam in (0, 20, 40):  # 2 m above the ground
                down = math.radians(27.75 - 0.5 * beam)
                self.assertAlmostEqual(ranges[beam], 2.0 / math.sin(down), delta=1e-3)
            self.assertEqual(ranges[63], 50.0)


if __name__ == "__main__":
    unittest.main()
