"""The builder beside MORSE 1.4: every class and method there is, by lists that nobody derives from
our own table.
"""

import inspect
import os
import re
import subprocess
import sys
import unittest

from support import HERE, PYTHON, SCRIPTS, SOURCE, environment

sys.dont_write_bytecode = True
sys.path.insert(0, PYTHON)

import morse.builder as builder  # noqa: E402
from morse.builder import blenderobjects, bpymorse, data, scene  # noqa: E402

SENSORS = """Accelerometer ArmaturePose Attitude Barometer Battery CompoundSensor GPS Gyroscope IMU
    Magnetometer Odometry Pose Proximity PTUPosture SearchAndRescue StereoUnit Thermometer
    LaserSensorWithArc Hokuyo Sick SickLDMRS Infrared Velocity VideoCamera DepthCamera Velodyne
    VelodyneZB SemanticCamera VelodyneRayCast Clock Kinect Collision RadarAltimeter
    Airspeed""".split()
ACTUATORS = """Arucomarker Destination ForceTorque MocapControl Gripper Keyboard Joystick Orientation
    PA10 PTU RotorcraftAttitude RotorcraftVelocity RotorcraftWaypoint StabilizedQuadrotor SteerForce
    Teleport MotionVW MotionVWDiff Waypoint MotionXYW Light Sound Armature KukaLWR Drag ExternalForce
    QuadrotorDynamicControl""".split()
ROBOTS = """Morsy ATRV B21 Hummer Jido Victim Human BarePR2 BasePR2 LocalizedPR2 NavPR2 FakeRobot
    QUAD2012 Quadrotor RMax Submarine Pioneer3DX SegwayRMP400 PatrolBot""".split()
GROUND = set(ROBOTS) - {"FakeRobot", "QUAD2012", "Quadrotor", "RMax", "Submarine"}
WHEELED = {"Pioneer3DX", "SegwayRMP400", "PatrolBot"}
OF_MODULES = "bpymorse math sys logging os TimeStrategies timer".split()

# A few numbers of MORSE's documentation, straight into the table: name -> (rate, what is set).
NUMBERS = {
    "Hokuyo": (10.0, {"laser_range": 30.0, "scan_window": 270.0, "resolution": 0.25}),
    "Sick": (10.0, {"laser_range": 30.0, "scan_window": 180.0, "resolution": 1.0}),
    "SickLDMRS": (4.0, {"layers": 4, "layer_separation": 0.8, "layer_offset": 0.125}),
    "Infrared": (10.0, {"laser_range": 2.0, "scan_window": 20.0, "Visible_arc": True}),
    "Proximity": (12.0, {"Range": 30.0, "Track": "Robot_Tag"}),
    "SearchAndRescue": (6.0, {"Heal_range": 2.0, "Abilities": "1,2"}),
    "VideoCamera": (20.0, {"cam_width": 256, "cam_height": 256, "cam_focal": 35.0}),
    "DepthCamera": (20.0, {"cam_near": 1.0, "cam_far": 20.0}),
    "SemanticCamera": (20.0, {"cam_width": 512, "cam_height": 512}),
    "VelodyneRayCast": (60.0, {"laser_range": 50.0, "scan_window": 31.5, "resolution": 0.5}),
    "PTU": (60.0, {"Speed": 1.0, "Tolerance": 0.01, "Manual": False}),
    "Gripper": (60.0, {"Angle": 60.0, "Distance": 0.5}),
    "Battery": (60.0, {"DischargingRate": 0.05}),
    "Pose": (60.0, {}),
}


def make(name):
    """One of a builder's class."""
    made = getattr(builder, name)
    return made([]) if name == "CompoundSensor" else made()


class Names(unittest.TestCase):
    def test_the_counts_of_the_lists(self):
        self.assertEqual((len(SENSORS), len(ACTUATORS), len(ROBOTS)), (34, 27, 19))

    def test_the_star_import_has_them(self):
        names = {}
        exec("from morse.builder import *", names)
        methods = [line.split(":")[0] for line in morse_1_4()]
        for name in SENSORS + ACTUATORS + ROBOTS + OF_MODULES + methods:
            self.assertIn(name, names)

    def test_the_table_has_no_others(self):
        # DepthVideoCamera is what a Kinect is made of.
        self.assertEqual(sorted(data.COMPONENTS), sorted(SENSORS + ACTUATORS +
                                                         ["DepthVideoCamera"]))
        for name, entry in data.COMPONENTS.items():
            kind = "actuator" if name in ACTUATORS else "sensor"
            self.assertEqual(entry["kind"], kind, name)

    def test_modules_that_scripts_import(self):
        for module, names in (("sensors", SENSORS), ("actuators", ACTUATORS), ("robots", ROBOTS),
                              ("creator", ["ComponentCreator", "SensorCreator",
                                           "ActuatorCreator"]),
                              ("blenderobjects", ["Plane", "Cube", "Sphere", "IcoSphere",
                                                  "Cylinder", "Cone", "Torus", "Empty",
                                                  "Coordsys", "Spot", "Camera"])):
            found = __import__("morse.builder." + module, fromlist=["*"])
            for name in names:
                self.assertTrue(hasattr(found, name), "%s.%s" % (module, name))

    def test_primitives_take_a_name_and_can_be_placed(self):
        for name in "Plane Cube Sphere IcoSphere Cylinder Cone Torus Empty".split():
            shape = getattr(blenderobjects, name)("it_is_a_" + name)
            self.assertEqual(shape.name, "it_is_a_" + name)
            shape.scale = (1, 2, 3)
            shape.translate(x=1)
            shape.rotate(z=1)
            shape.color(1, 0, 0)
            shape.properties(Type=name)
            self.assertEqual(shape._bpy_object.game.physics_type, "NO_COLLISION")


def morse_1_4():
    with open(os.path.join(HERE, "morse_1_4.txt"), encoding="utf-8") as file:
        return [line.strip() for line in file if line.strip() and not line.startswith("#")]


class Methods(unittest.TestCase):
    """Each is there and takes what MORSE's takes."""


def _methods_of(line):
    name, rest = line.split(":", 1)

    def test(self):
        known = getattr(builder, name)
        for method, count in re.findall(r"(\w+)\((\d)\)", rest):
            function = getattr(known, method, None)
            self.assertTrue(callable(function), "%s.%s" % (name, method))
            is_static = isinstance(inspect.getattr_static(known, method), staticmethod)
            arguments = [None] * (int(count) + (0 if is_static else 1))
            inspect.signature(function).bind(*arguments)

    return test


for _line in morse_1_4():
    setattr(Methods, "test_c_methods_of_" + _line.split(":")[0], _methods_of(_line))


class Components(unittest.TestCase):
    """One test for each row of the table: made, named, placed, set up."""


def _component(name):
    def test(self):
        entry = data.COMPONENTS[name]
        component = make(name)
        self.assertIn(component.property_value("classpath"), {entry["classpath"]})
        self.assertEqual(component.rate, entry["frequency"])
        for key, value in entry["presets"].items():
            self.assertEqual(component.property_value(key), value, key)
        component.translate(x=1.0, y=2.0)
        component.translate(z=3.0)
        self.assertEqual(list(component.location), [1.0, 2.0, 3.0])
        component.rotate(z=0.5)
        component.frequency(7)
        self.assertEqual(component.rate, 7.0)
        for key, value in entry["properties"].items():
            component.properties(**{key: value})
        robot = builder.FakeRobot()
        part = component
        robot.append(part)
        self.assertIs(part.parent, robot)
        if component.is_exportable():
            component.add_service("socket")
            self.assertIn("socket", component.services)
            served = entry["streams"].get(entry["default_level"], ["socket"])
            component.add_stream("socket")
            if name == "Kinect":
                self.assertEqual(len(component.video_camera.streams), 1)
            elif "socket" in served:
                self.assertEqual([stream["direction"] for stream in component.streams],
                                 ["OUT" if entry["kind"] == "sensor" else "IN"])
            else:
                self.assertEqual(component.streams, [])
        else:
            self.assertIn(name, ("Keyboard", "Joystick", "Drag"))
        for level in entry["levels"]:
            component.level(level)
            self.assertEqual(component.property_value("abstraction_level"), level)
        for modifier, classpath in entry["modifiers"].items():
            component.alter(modifier)
            self.assertEqual(component.modifiers[-1]["classpath"], classpath)
        self.assertEqual(scene.simulated_type(component), entry["simulated"])

    return test


for _name in SENSORS + ACTUATORS:
    setattr(Components, "test_b_" + _name, _component(_name))


class Table(unittest.TestCase):
    def test_rates_and_presets_of_morse(self):
        for name, (rate, presets) in NUMBERS.items():
            entry = data.COMPONENTS[name]
            self.assertEqual(entry["frequency"], rate, name)
            for key, value in presets.items():
                self.assertEqual(entry["presets"][key], value, "%s.%s" % (name, key))

    def test_each_row_is_complete(self):
        keys = {"name", "kind", "classpath", "implementations", "frequency", "levels",
                "default_level", "fields", "properties", "presets", "services", "streams",
                "modifiers", "exportable", "needs", "simulated"}
        for name, entry in data.COMPONENTS.items():
            self.assertEqual(set(entry) - {"base"}, keys, name)
            self.assertIn(entry["default_level"], entry["levels"])
            self.assertIn(entry["needs"], ("rendering", "armature", None))
            for field in entry["fields"]:
                self.assertLessEqual({"name", "type", "default"}, set(field), name)
                self.assertLessEqual(set(field.get("levels", [])), set(entry["levels"]))
            for service in entry["services"]:
                self.assertEqual(set(service),
                                 {"name", "parameters", "asynchronous", "interruptible"})

    def test_fields_services_and_properties_that_clients_use(self):
        def fields(name):
            return [field["name"] for field in data.COMPONENTS[name]["fields"]]

        def services(name):
            return {service["name"]: [parameter["name"] for parameter in service["parameters"]]
                    for service in data.COMPONENTS[name]["services"]}

        self.assertEqual(fields("Pose"), ["x", "y", "z", "yaw", "pitch", "roll"])
        self.assertEqual(fields("MotionVW"), ["v", "w"])
        self.assertEqual(services("MotionVW"), {"set_speed": ["v", "w"], "stop": []})
        self.assertEqual(services("Waypoint")["goto"], ["x", "y", "z", "tolerance", "speed"])
        self.assertEqual(fields("Sick"), ["point_list", "range_list", "remission_list"])
        self.assertEqual(data.COMPONENTS["Odometry"]["implementations"]["integrated"],
                         "IntegratedOdometry")
        self.assertEqual(data.COMPONENTS["Waypoint"]["properties"]["AngleTolerance"],
                         0.17453292519943295)

    def test_what_is_simulated_is_what_the_simulator_has(self):
        with open(os.path.join(SOURCE, "src", "scene", "scenario.cpp"), encoding="utf-8") as file:
            text = file.read()
        body = text[text.index("& ComponentTypes() {"):]
        known = set(re.findall(r'"(\w+)"', body[:body.index(";")]))
        simulated = {entry["simulated"] for entry in data.COMPONENTS.values()} - {None}
        self.assertEqual(simulated | set(data.SYROTEK_COMPONENTS.values()), known)


    def test_what_is_simulated_is_in_a_script(self):
        text = ""
        for folder, _, files in os.walk(SCRIPTS):
            for name in files:
                if name.endswith(".py"):
                    with open(os.path.join(folder, name), encoding="utf-8") as file:
                        text += file.read()
        # What all scanners are is in none by itself.
        missing = [name for name, entry in data.COMPONENTS.items() if entry["simulated"] and
                   name != "LaserSensorWithArc" and not re.search(r"\b%s\(" % name, text)]
        self.assertEqual(missing, [])

    def test_the_documentation_says_what_is_simulated(self):
        with open(os.path.join(SOURCE, "docs", "morse.md"), encoding="utf-8") as file:
            rows = re.findall(r"^\| `(\w+)` \| (yes|no)\b", file.read(), re.MULTILINE)
        self.assertEqual(dict(rows), {name: "yes" if entry["simulated"] else "no"
                                      for name, entry in data.COMPONENTS.items()})


class Robots(unittest.TestCase):
    """One test for each robot."""


def _robot(name):
    def test(self):
        robot = getattr(builder, name)()
        self.assertEqual(robot.property_value("GroundRobot"), name in GROUND)
        self.assertEqual(isinstance(robot, builder.WheeledRobot), name in WHEELED)
        self.assertIs(robot.property_value("Robot_Tag"), True)
        robot.set_mass(5.0)
        robot.set_friction(1.0)
        robot.add_default_interface("socket")
        named = getattr(builder, name)(name="a_name")
        self.assertEqual(named.basename, "a_name")
        self.assertIsNotNone(robot.body_entry())

    return test


for _name in ROBOTS:
    setattr(Robots, "test_b4_" + _name, _robot(_name))


class Facade(unittest.TestCase):
    def test_c7_objects_have_what_scripts_read_and_set(self):
        item = bpymorse.Object("Item")
        for name in ("physics_type", "mass", "radius", "use_actor", "use_collision_bounds",
                     "collision_bounds_type", "use_collision_compound", "lock_location_x",
                     "lock_location_y", "lock_location_z", "properties", "sensors",
                     "controllers"):
            getattr(item.game, name)
            setattr(item.game, name, getattr(item.game, name))
        child = bpymorse.Object("Child")
        child.parent = item
        self.assertEqual(item.children, [child])
        item.location = (1, 2, 3)
        item.rotation_euler = (0, 0, 1.5707963267948966)
        child.location = (1, 0, 0)
        self.assertAlmostEqual(child.matrix_world[1][3], 3.0)
        self.assertEqual(bpymorse.get_object("Child"), child)
        again = bpymorse.Object("Child")
        self.assertEqual(again.name, "Child.001")
        bpymorse.delete(again)
        self.assertIsNone(bpymorse.get_object("Child.001"))

    def test_c1_types_of_properties(self):
        item = bpymorse.Object("Typed")
        bpymorse.properties(item, a=True, b=1, c=1.5, d="x", e=builder.timer(0.0))
        self.assertEqual([item.game.properties[name].type for name in "abcde"],
                         ["BOOL", "INT", "FLOAT", "STRING", "TIMER"])


class Standing(unittest.TestCase):
    def test_it_comes_before_debians_package(self):
        # Where Debian's python3-morse-simulator is installed there is another package morse.
        result = subprocess.run(
            [sys.executable, "-c", "from morse.builder import *; import morse; print(morse.__file__)"],
            env=environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            universal_newlines=True, check=False)
        self.assertEqual(result.stdout.strip(), os.path.join(PYTHON, "morse", "__init__.py"))

    def test_time_strategies_as_morse_testing_needs_them(self):
        from morse.core.morse_time import TimeStrategies
        self.assertEqual((TimeStrategies.BestEffort, TimeStrategies.FixedSimulationStep), (0, 1))
        self.assertEqual(TimeStrategies.human_repr(0), "Best Effort")
        self.assertEqual(TimeStrategies.human_repr(1), "Fixed Simulation Step")
        self.assertIsInstance(TimeStrategies.python_repr(1), bytes)


if __name__ == "__main__":
    unittest.main()
