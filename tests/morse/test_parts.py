"""Sensors, actuators and modifiers of what is felt, carried, found and said in other coordinates:
builder scripts in the simulator, read by pymorse, with numbers of calculations of their own.

Each test runs under both time strategies. CCMORSE names the program. Needs python3-morse-simulator
for pymorse.
"""

import math
import os
import socket
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


class Wire:
    """A client of lines."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), 30.0)
        self.file = self.socket.makefile("r", encoding="utf-8", newline="\n")

    def send(self, line):
        self.socket.sendall(line.encode() + b"\n")

    def read(self):
        return self.file.readline().rstrip("\n")

    def close(self):
        self.file.close()
        self.socket.close()


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


class Themselves(unittest.TestCase):
    @both
    def test_b4_a_victim_heals_itself(self, pace):
        with Run("robots_services.py", pace=pace) as run:
            morse = run.morse
            self.assertEqual(sorted(morse.rpc("simulation", "list_robots")),
                             ["casualty", "human", "robot", "silent", "victim"])
            known = {one["name"]: one for one in morse.rpc("simulation", "details")["robots"]}
            self.assertEqual(known["victim"]["services"],
                             ["get_configurations", "get_properties", "heal", "set_property"])
            self.assertNotIn("services", known["silent"])
            morse.sleep(0.5)
            self.assertEqual(set(read(run, "robot.rescuer")["victim_dict"]),
                             {"victim", "casualty"})
            self.assertIsNone(morse.rpc("victim", "heal"))
            self.assertIsNone(morse.rpc("victim", "heal"))  # of no effect
            morse.sleep(0.6)
            self.assertEqual(set(read(run, "robot.rescuer")["victim_dict"]), {"casualty"})
            now = morse.rpc("victim", "get_properties")["properties"]
            self.assertEqual([now[name][0] for name in ("Injured", "Severity", "Requirements")],
                             [False, 0, ""])
            # Taken ill again, and another one worse.
            morse.rpc("victim", "set_property", "Injured", True)
            morse.rpc("casualty", "set_property", "Severity", 4)
            morse.sleep(0.6)
            seen = read(run, "robot.rescuer")["victim_dict"]
            self.assertEqual(seen["victim"]["requirements"], [])
            self.assertEqual(seen["casualty"]["severity"], 4)
            for name, value in (("Severity", "bad"), ("NoGravity", True), ("Pulse", 60)):
                with self.assertRaises(pymorse.MorseServiceFailed):
                    morse.rpc("victim", "set_property", name, value)
            for robot, service in (("silent", "heal"), ("human", "heal"), ("victim", "grasp")):
                with self.assertRaisesRegex(pymorse.MorseServiceFailed, "not been registered"):
                    morse.rpc(robot, service)

    @both
    def test_b4_a_human_grasps(self, pace):
        with Run("robots_services.py", pace=pace) as run:
            morse = run.morse
            for name in ("far_cup", "victim", "nothing"):
                with self.assertRaises(pymorse.MorseServiceFailed):
                    morse.rpc("human", "grasp", True, name)
            self.assertIs(morse.rpc("human", "grasp", True, "cup"), True)
            morse.rpc("human.teleport", "translate", 3.0)
            morse.sleep(0.3)
            near = read(run, "human.proximity")["near_objects"]
            self.assertAlmostEqual(near["cup"], 0.6, places=6)  # it came along
            self.assertAlmostEqual(near["far_cup"], 5.0, places=6)
            self.assertIs(morse.rpc("human", "grasp", False, "cup"), True)
            morse.rpc("human.teleport", "translate", -1.0)
            morse.sleep(0.3)
            self.assertAlmostEqual(read(run, "human.proximity")["near_objects"]["cup"], 1.6,
                                   places=6)
            with self.assertRaises(pymorse.MorseServiceFailed):
                morse.rpc("human", "grasp", True, "cup")  # out of reach now


class Overlaid(unittest.TestCase):
    @both
    def test_c8_services_that_answer_at_once(self, pace):
        with Run(os.path.join("overlays", "default.py"), pace=pace) as run:
            morse = run.morse
            # Of the name of its class, which it is given, which it has itself.
            self.assertEqual(morse.rpc("Where", "in_millimetres"), 500)
            self.assertEqual(morse.rpc("Where", "in_millimetres", "z"), 100)
            self.assertEqual(morse.rpc("Where", "who"), ["robot.pose", "robot", 0.5, 0.1])
            self.assertEqual(morse.rpc("eye", "look_as_far_as", 12.5), 12.5)
            self.assertEqual(morse.rpc("guide", "where_to"), 1.0)
            self.assertEqual(morse.rpc("clerk", "twice", 20), 42)
            self.assertGreaterEqual(read(run, "robot.counter")["sum"], 20)
            # The component's own services are there as before, and not the overlay's.
            morse.rpc("robot.proximity", "set_range", 7.0)
            for component, service in (("robot.pose", "who"), ("Where", "get_local_data"),
                                       ("Where", "scaled")):
                with self.assertRaisesRegex(pymorse.MorseServiceFailed, "not been registered"):
                    morse.rpc(component, service)
            self.assertNotIn("guide", str(morse.rpc("simulation", "details")))

    @both
    def test_c8_services_that_answer_later(self, pace):
        with Run(os.path.join("overlays", "default.py"), pace=pace) as run:
            morse = run.morse
            before = morse.time()
            self.assertEqual(morse.rpc("guide", "walk", 2.0, 0.0), "way 1")
            # 1.8 m at 1 m/s, half of what it was told, as the script says.
            self.assertGreater(morse.time() - before, 1.7)
            self.assertEqual(morse.rpc("guide", "walk", 4.0, 0.0, 4.0), "way 2")
            # A second call preempts the first, and so does one of the component's own.
            client = Wire(run.port)
            client.send("a guide walk [20.0, 5.0]")
            client.send("b guide plain [20.0, 5.0]")
            self.assertEqual(client.read(), "a PREEMPTED")
            client.send("c robot.waypoint goto [20.0, 9.0, 0.0, 0.2, 1.0]")
            self.assertEqual(client.read(), "b PREEMPTED")
            client.send("d guide plain [20.0, 5.0]")
            self.assertEqual(client.read(), "c PREEMPTED")
            client.send("d cancel")
            self.assertEqual(client.read(), "d PREEMPTED")
            client.send("e guide plain [30.0, 5.0]")
            self.assertIsNone(morse.rpc("guide", "halt"))
            self.assertEqual(morse.rpc("robot.waypoint", "get_status"), "Stop")
            client.send("e cancel")
            self.assertEqual(client.read(), "e PREEMPTED")
            # Of a component of one's own.
            start = read(run, "robot.counter")["sum"]
            self.assertGreaterEqual(morse.rpc("clerk", "wait_for", 30), start + 30)
            client.send("f clerk wait_for [1000000]")
            client.send("g robot.counter count_up [1000000]")
            self.assertEqual(client.read(), "f PREEMPTED")
            client.send("h clerk wait_for [1000000]")
            self.assertEqual(client.read(), "g PREEMPTED")
            client.send("h cancel")
            self.assertEqual(client.read(), "h PREEMPTED")
            client.close()

    @both
    def test_c8_what_fails_is_said(self, pace):
        with Run(os.path.join("overlays", "default.py"), pace=pace) as run:
            morse = run.morse
            for request, text in ((("Where", "fly"), "robot.pose has no service 'fly'"),
                                  (("Where", "push"), "does nothing to the world itself"),
                                  (("Where", "in_millimetres", "q"), "KeyError"),
                                  (("eye", "refuse"), "^not with me$"),
                                  (("eye", "look_as_far_as", "far"), "wrong parameter type"),
                                  (("guide", "nothing"), "has not been registered")):
                with self.assertRaisesRegex(pymorse.MorseServiceFailed, text):
                    morse.rpc(*request)
            with self.assertRaises(TypeError):
                morse.rpc("eye", "look_as_far_as", 1.0, 2.0)
            with self.assertRaisesRegex(TypeError, "chain_callback"):
                morse.rpc("guide", "without_a_callback")
            # They all go on.
            self.assertEqual(morse.rpc("eye", "look_as_far_as", 3.0), 3.0)
            morse.rpc("clerk", "drive", 1.0)
            morse.sleep(1.0)
            self.assertGreater(read(run, "robot.pose")["x"], 1.2)


if __name__ == "__main__":
    unittest.main()
