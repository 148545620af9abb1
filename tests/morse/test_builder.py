"""MORSE's builder: scripts as its users write them, and the scenes that come of them.

Each script in scripts/ is about one feature (specs: MORSE 1.4, parts C and H.1; thesis 4.1, 4.2).
"""

import math
import os
import shutil
import sys
import tempfile
import textwrap
import unittest

from support import PYTHON, SCRIPTS, Built


class Scripts(unittest.TestCase):
    def near(self, given, expected):
        self.assertEqual(len(given), len(expected))
        for a, b in zip(given, expected):
            self.assertAlmostEqual(a, b, places=9)

    def test_s10_the_default_scene_of_morse(self):
        built = Built("default_scene.py")
        self.assertEqual(built.status, 0, built.output)
        self.assertEqual(built.robots(), ["robot"])
        robot = built.robot("robot")
        self.assertEqual(robot["pose"], {"x": 1.0, "y": 0.0, "yaw": 3.5 - 2.0 * math.pi})
        self.assertEqual(robot["body"]["mass"], 15.0)
        self.assertEqual(built.components(), ["motion", "keyboard", "pose"])
        self.assertTrue(built.component("robot.motion")["stream"])
        self.assertTrue(built.component("robot.pose")["services"])
        self.assertEqual(built.scene["camera"], {"position": [-18.0, -6.7, 10.8],
                                                 "rotation": [1.09, 0, -1.14]})
        self.assertEqual(built.scene["world"]["name"], "morse_sandbox")
        self.assertEqual(built.component("robot.keyboard")["properties"],
                         {"ControlType": "Position"})
        self.assertFalse(built.component("robot.keyboard")["stream"])
        keyboard = built.objects()["robot"]["children"][1]
        self.assertEqual(keyboard["properties"]["ControlType"], "Position")
        self.assertEqual(keyboard["streams"], [])  # it is not exportable

    def test_two_kinds_of_robot_and_cameras(self):
        built = Built("cat_and_mouse.py")
        self.assertEqual(built.robots(), ["mouse", "cat"])
        self.assertEqual(built.components("mouse"), ["keyboard", "pose"])
        self.assertEqual(built.components("cat"), ["motion", "semanticL", "semanticR"])
        self.assertEqual(built.robot("cat")["body"]["mass"], 90.0)
        # Streamed, but never asked for services.
        self.assertEqual((built.component("cat.motion")["stream"],
                          built.component("cat.motion")["services"]), (True, False))
        self.near(built.component("cat.semanticR")["position"], [0.2, -0.3, 0.9])
        self.assertEqual(built.objects()["mouse"]["properties"]["Label"], "MOUSE")
        self.assertEqual(built.settings()["camera"]["display"], "cat.semanticL")

    def test_c6_one_variable_for_components_of_two_robots(self):
        built = Built("two_robots.py")
        self.assertEqual(built.robots(), ["r1", "r2"])
        self.assertEqual(built.components("r1"), ["pose"])
        self.assertEqual(built.components("r2"), ["pose"])
        self.assertEqual(built.robot("r1")["pose"]["x"], -3.0)

    def test_c6_robots_named_by_their_constructor(self):
        built = Built("robots_in_a_loop.py")
        self.assertEqual(built.robots(), ["patrol0", "patrol1", "patrol2", "patrol3"])
        for name in built.robots():
            self.assertEqual(built.components(name), ["motion", "pose"])
        self.assertEqual(built.robot("patrol3")["pose"]["x"], 9.0)

    def test_c6_close_context_names_a_functions_variables(self):
        built = Built("close_context.py")
        self.assertEqual(built.robots(), ["leader", "follower"])
        self.assertEqual(built.components("follower"), ["odometry"])

    def test_c6_names_that_clash_are_numbered(self):
        built = Built("names_clash.py")
        self.assertEqual(built.robots(), ["m", "m_001", "m_002"])
        self.assertEqual([line for line, _ in built.notes()], [5, 7])

    def test_c1_a_name_has_no_dot(self):
        built = Built("name_with_a_dot.py")
        self.assertEqual(built.status, 1)
        self.assertIn("name_with_a_dot.py\", line 4", built.output)
        self.assertIn("SyntaxError", built.output)
        self.assertIn("[ERROR][MORSE]", built.output)

    def test_c6_attributes_of_self_name_components(self):
        built = Built("names_by_self.py")
        self.assertEqual(built.robots(), ["walker"])
        self.assertEqual(built.components("walker"), ["where", "go"])
        self.assertEqual(built.component("walker.where")["services"], False)
        self.assertEqual(built.component("walker.go")["stream"], False)

    def test_c6_unnamed_robots_keep_the_objects_names(self):
        built = Built("odd_robot_list.py")
        # The last one is still in the loop's variable.
        self.assertEqual(built.robots(), ["FakeRobot", "FakeRobot_001", "r"])
        self.assertEqual([built.components(name) for name in built.robots()], [["pose"]] * 3)

    def test_components_mounted_on_components(self):
        built = Built("nested_components.py")
        self.assertEqual(built.components(), ["ptu", "ptu.pose"])
        pose = built.component("robot.ptu.pose")
        # The unit looks to the left: 0.5 m ahead of it is 0.5 m to the left of its own place.
        self.near(pose["position"], [0.2, 0.5, 1.0])
        self.near(pose["rotation"], [0.0, 0.0, math.pi / 2.0])
        self.assertEqual(built.objects()["robot"]["children"][0]["children"][0]["name"],
                         "robot.ptu.pose")

    def test_r10_scanners(self):
        built = Built("scanners.py")
        self.assertEqual(built.components(), ["hokuyo", "sick", "many", "ir1", "rear", "turning"])
        hokuyo = built.component("robot.hokuyo")
        self.near(hokuyo["position"], [0.252, 0.0, 0.5])
        self.assertEqual(hokuyo["frequency"], 5.0)
        self.assertEqual(hokuyo["laser"], {
            "range": 5.0, "scan_window_deg": 270.0, "resolution_deg": 0.5, "visible_arc": True,
            "layers": 1, "layer_separation": 0.8, "layer_offset": 0.125})
        sick = built.component("robot.sick")
        self.near(sick["rotation"], [0.0, 0.1, math.pi])
        self.assertEqual(sick["laser"]["range"], 30.0)
        self.assertEqual(sick["laser"]["scan_window_deg"], 180.0)
        self.assertEqual(sick["frequency"], 10.0)
        self.assertEqual(built.component("robot.many")["laser"]["layers"], 4)
        self.assertEqual(built.component("robot.many")["frequency"], 4.0)
        # What is set after create_laser_arc() does not count.
        self.assertEqual(built.component("robot.ir1")["laser"]["range"], 1.5)
        # A class of the user's own is what it derives from.
        self.assertEqual(built.component("robot.rear")["laser"]["resolution_deg"], 0.25)
        self.assertEqual(built.component("robot.turning")["laser"]["scan_window_deg"], 31.5)
        self.assertEqual(built.notes(), [])

    def test_h1_the_boxes_of_the_scanners_environment(self):
        world = Built("scanners.py").scene["world"]
        self.assertEqual(world["size"], [39, 30])
        places = {box["kind"]: (box["x"], box["y"], box["size"]) for box in world["boxes"]}
        self.assertEqual(places["RedBox"], (-7.5, 0, [1, 1]))
        self.assertEqual(places["BlueBox"], (-3.5, -3, [1, 1]))
        self.assertEqual(places["GreenBox"], (-6.5, 6, [1, 1]))

    def test_c1_levels(self):
        built = Built("levels.py")
        self.assertEqual(built.components(), ["odometry", "raw", "gps"])
        self.assertEqual(built.component("robot.odometry")["level"], "integrated")
        self.assertEqual(built.component("robot.raw")["level"], "raw")
        self.assertEqual(built.component("robot.gps")["level"], "extended")
        self.assertEqual(built.scene["geodesy"],
                         {"longitude": 43.6, "latitude": 1.4333, "altitude": 135.0})
        children = built.objects()["robot"]["children"]
        self.assertEqual([child["level"] for child in children], ["integrated", "raw", "extended"])
        self.assertEqual(children[0]["properties"]["abstraction_level"], "integrated")
        self.assertEqual(built.notes(), [])
        self.assertEqual(built.settings()["properties"]["longitude"], 43.6)

    def test_c5_the_fastest_component_sets_the_pace(self):
        built = Built("frequencies.py")
        self.assertEqual(built.scene["time"]["frequency"], 120.0)
        self.assertEqual(built.component("robot.slow")["frequency"], 1.0)

    def test_c5_unless_it_is_not_to_be_tuned(self):
        self.assertEqual(Built("frequencies_not_tuned.py").scene["time"]["frequency"], 60.0)

    def test_s19_fixed_steps(self):
        built = Built("fixed_step.py")
        self.assertEqual(built.scene["time"], {"frequency": 50.0, "factor": 1.0,
                                               "strategy": "fixed_simulation_step"})
        self.assertIs(built.settings()["time"]["relative"], True)

    def test_s19_time_scale(self):
        self.assertEqual(Built("time_scale.py").scene["time"], {
            "frequency": 60.0, "factor": 4.0, "strategy": "best_effort"})

    def test_b5_noise_of_a_pose(self):
        built = Built("noise.py")
        self.assertEqual(built.component("robot.pose")["modifiers"], [
            {"type": "PoseNoise", "settings": {"pos_std": 0.1, "rot_std": 0.02}}])
        self.assertEqual(built.component("robot.ned")["modifiers"],
                         [{"type": "NED", "settings": {}}])
        self.assertEqual(built.notes(), [])
        self.assertEqual(built.objects()["robot"]["children"][1]["modifiers"][0]["classpath"],
                         "morse.modifiers.ned.CoordinatesToNED")

    def test_b5_a_modifier_that_a_class_has_not(self):
        built = Built("modifier_of_nobody.py")
        self.assertEqual(built.status, 1)
        self.assertIn("line 6", built.output)
        self.assertIn("KeyError: 'Noise'", built.output)

    def test_b6_zones(self):
        built = Built("zones_and_batteries.py")
        zone = built.objects()["zone"]
        self.assertEqual(zone["scale"], [2.0, 2.0, 2.0])
        self.assertEqual(zone["rotation"], [0.0, 0.0, 0.0])
        self.assertEqual(zone["properties"]["Type"], "Charging")
        self.assertEqual(built.notes(), [])
        self.assertEqual(built.scene["zones"], [{"type": "Charging", "position": [10.0, 0.0, 0.0],
                                                 "half_size": [2.0, 2.0, 2.0]}])
        self.assertEqual(built.component("robot.battery")["properties"],
                         {"DischargingRate": 10.0})
        battery = built.objects()["robot"]["children"][0]
        self.assertEqual(battery["properties"]["DischargingRate"], 10.0)

    def test_b6_passive_objects(self):
        built = Built("passive_objects.py")
        table, cup = built.scene["props"]
        self.assertEqual((table["name"], table["object"]), ("table", "SmallTable"))
        self.near(table["position"], [3.5, -3.0, 0.0])
        self.near(table["rotation"], [0.0, 0.0, 0.2])
        self.assertEqual(cup["object"], "Cup")
        self.assertTrue(built.objects()["cup"]["properties"]["Graspable"])
        self.assertEqual(built.objects()["table"]["properties"]["Label"], "THE TABLE")
        self.assertTrue(built.scene["environment"].endswith("indoors-1/indoor-1.blend") or
                        built.scene["environment"] == "indoors-1/indoor-1")

    def test_b6_primitives(self):
        built = Built("primitives.py")
        objects = built.objects()
        self.assertEqual(objects["ball"]["scale"], [0.5, 0.5, 0.5])
        self.assertEqual(objects["ball"]["color"], [1, 0, 0])
        self.assertEqual(objects["c9"]["class"], "Camera")
        # A name given to the constructor stays.
        self.assertEqual(objects["floor"]["class"], "Plane")

    def test_c8_overlays(self):
        built = Built("overlay.py")
        overlay = built.objects()["robot"]["children"][0]["overlays"][0]
        self.assertEqual(overlay["classpath"], "my_project.overlays.WaypointOverlay")
        self.assertEqual(overlay["settings"], {"namefrom": "here"})
        # There is no such module, as the script is told.
        self.assertEqual([line for line, _ in built.notes()], [7])
        self.assertNotIn("overlays", built.robot("robot")["components"][0])

    def test_c8_overlays_of_ones_own_package(self):
        built = Built(os.path.join("overlays", "default.py"))
        self.assertEqual((built.status, built.notes()), (0, []), built.output)
        parts = {part["name"]: part for part in built.robot("robot")["components"]}
        guide, = parts["waypoint"]["overlays"]
        self.assertEqual((guide["code"], guide["settings"]),
                         ("overlaid.overlays.Guide", {"slowness": 2.0}))
        self.assertTrue(guide["path"][0].endswith(os.path.join("overlays", "src")))
        walk = next(one for one in guide["services"] if one["name"] == "walk")
        self.assertEqual(walk, {"name": "walk", "asynchronous": True, "parameters": [
            {"name": "x", "optional": False}, {"name": "y", "optional": False},
            {"name": "speed", "optional": True}]})
        self.assertEqual(parts["counter"]["overlays"][0]["code"], "overlaid.overlays.Clerk")

    def test_b4_services_of_robots(self):
        built = Built("robots_services.py")
        skills = {robot["name"]: robot.get("skills") for robot in built.scene["robots"]}
        # Only with add_service().
        self.assertEqual(skills, {"robot": None, "victim": ["heal"], "casualty": ["heal"],
                                  "silent": None, "human": ["grasp"]})

    def test_c7_what_scripts_reach_into(self):
        built = Built("bpy_facade.py")
        self.assertEqual(built.status, 0, built.output)
        robot = built.robot("robot")
        self.assertEqual(robot["pose"]["x"], 1.5)
        self.assertEqual(robot["body"]["origin_height"], 2.5)

    def test_c4_every_setting_of_an_environment(self):
        built = Built("environment_settings.py")
        self.assertEqual(built.status, 0, built.output)
        self.assertNotIn("[ERROR][MORSE]", built.output)  # morse.testing would stop at it
        settings = built.settings()
        self.assertEqual(settings["stream_managers"],
                         {"socket": {"time_sync": True, "sync_port": 6001}})
        self.assertEqual(settings["gravity"], 1.62)
        self.assertEqual(settings["physics_step_sub"], 5)
        self.assertEqual(settings["log_levels"], {"MORSE": "DEBUG"})
        self.assertEqual(settings["camera"]["clip"], [0.1, 1000])
        matters = {note["line"] for note in built.result["notes"] if note["matters"]}
        self.assertEqual(matters, {11, 21})
        self.assertEqual(built.scene["time"]["sync_port"], 6001)

    def test_c4_multinode(self):
        built = Built("multinode.py")
        self.assertEqual(built.settings()["multinode"]["distribution"],
                         {"node A": ["here"], "node B": ["there"]})
        self.assertEqual(built.scene["multinode"],
                         {"server": "localhost", "port": 65000,
                          "nodes": {"node A": ["here"], "node B": ["there"]}})
        self.assertEqual(built.notes(), [])

    def test_c3_bodies(self):
        built = Built("ghosts_and_paint.py")
        ghost, heavy = built.robot("ghost"), built.robot("heavy")
        self.assertEqual(ghost["body"]["hull"], [])  # no scanner sees it
        self.assertEqual(ghost["body"]["footprint"][1], [0.01, 0.01])  # and nothing touches it
        self.assertEqual(ghost["color"], "#ff0000")
        self.assertEqual(heavy["color"], "#00ff00")
        self.assertEqual(heavy["body"]["mass"], 33.5)
        self.assertEqual(built.objects()["heavy"]["friction"], 2.0)

    def test_c1_streams_of_other_middlewares(self):
        built = Built("middlewares.py")
        self.assertEqual(built.status, 0, built.output)
        streams = built.objects()["robot"]["children"][0]["streams"]
        self.assertEqual([stream["middleware"] for stream in streams],
                         ["ros", "socket", "text", "socket"])
        self.assertEqual(streams[3]["method"],
                         "morse.middleware.socket_datastream.SocketPublisher")
        self.assertEqual([line for line, _ in built.notes()], [6, 8])
        self.assertIn("no middleware is called fax", built.output)
        self.assertIn("generic stream", built.output)

    def test_c1_what_is_not_exportable_ends_the_program(self):
        built = Built("keyboard_has_no_stream.py")
        self.assertEqual(built.status, 1)
        self.assertIn("[ERROR][MORSE]", built.output)
        self.assertIn("keyboard_has_no_stream.py:6", built.output)

    def test_h1_sizes_and_masses_of_all_robots(self):
        built = Built("all_robots.py")
        self.assertEqual(built.status, 0, built.output)
        self.assertEqual(len(built.robots()), 17)
        bodies = {name: built.robot(name)["body"] for name in built.robots()}
        self.assertEqual(bodies["atrv"]["mass"], 20.0)
        self.assertEqual(max(x for x, _ in bodies["atrv"]["footprint"]), 0.57)
        self.assertEqual(bodies["atrv"]["origin_height"], 0.1)
        self.assertEqual(bodies["segway"]["mass"], 90.0)
        self.assertEqual(bodies["quadrotor"]["origin_height"], 1.0)  # it flies
        self.assertEqual(bodies["pioneer"]["mass"], 9.0)
        self.assertEqual(len(bodies["b21"]["footprint"]), 16)  # it is round
        self.assertEqual(bodies["fake"]["hull"], [])
        self.assertEqual(built.components("pr2"),
                         ["joint_state", "base_scan", "odometry", "imu", "pose", "motion"])
        self.assertEqual(bodies["pr2"]["drive"], "omni")  # its MotionXYW goes sideways
        self.assertEqual(bodies["atrv"]["drive"], "diff")
        torso = next(child for child in built.objects()["pr2"]["children"]
                     if child["name"] == "pr2.torso")
        self.assertEqual([child["name"] for child in torso["children"]],
                         ["pr2.torso.pose", "pr2.torso.head", "pr2.torso.l_arm",
                          "pr2.torso.r_arm"])
        # The floor reaches beneath the last of them.
        world = built.scene["world"]
        self.assertLess(world["low"][0], -50.0)
        self.assertGreater(world["low"][0] + world["size"][0], 62.0)

    def test_b2_kinect_and_compound_sensors(self):
        built = Built("kinect_and_compound.py")
        children = {child["name"]: child for child in built.objects()["robot"]["children"]}
        rgb, depth = children["robot.Kinect"]["children"]
        self.assertEqual((rgb["name"], depth["name"]), ("robot.Kinect.rgb", "robot.Kinect.depth"))
        self.assertEqual(rgb["properties"]["cam_width"], 128)
        self.assertEqual(rgb["location"], [0.06, 0.08, 0.04])
        self.assertEqual(depth["frequency"], 15.0)
        self.assertEqual(len(rgb["streams"]), 1)
        self.assertEqual(children["robot.all_of_it"]["properties"]["sensors"],
                         "robot.pose,robot.clock")

    def test_d_arguments_follow_two_dashes(self):
        built = Built("arguments.py", "3")
        self.assertEqual(built.robots(), ["r0", "r1", "r2"])
        self.assertIn("making 3 robots", built.output)

    def test_b6_an_environment_that_is_not(self):
        built = Built("environment_of_nobody.py")
        self.assertEqual(built.status, 1)
        self.assertIn("[ERROR][MORSE]", built.output)
        self.assertIn("environment_of_nobody.py\", line 4", built.output)
        self.assertIn("i_do_not_exist", built.output)

    def test_a_script_without_environment(self):
        built = Built("no_environment.py")
        self.assertEqual(built.status, 1)
        self.assertIn("[ERROR][MORSE]", built.output)
        self.assertNotIn("Traceback", built.output)

    def test_errors_are_in_the_users_own_file(self):
        built = Built("error_in_the_script.py")
        self.assertEqual(built.status, 1)
        self.assertIn("error_in_the_script.py\", line 5", built.output)
        self.assertIn("AttributeError", built.output)
        self.assertNotIn("morse/builder", built.output)
        self.assertEqual(built.result, {})

    def test_components_of_ones_own(self):
        built = Built("old_style_sensor.py")
        # The simulator has a pen; of somebody's sensor it knows nothing.
        self.assertEqual(built.component("robot.pen")["type"], "Pen")
        self.assertEqual(built.components(), ["pen"])
        self.assertEqual([line for line, _ in built.notes()], [18])


class Thesis(unittest.TestCase):
    """The project of the thesis, 4.1 and 4.2, with its listings as they stand."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        project = os.path.join(cls.folder, "MorseSyrotek")
        shutil.copytree(os.path.join(SCRIPTS, "thesis"), project)
        cls.built = Built(os.path.join(project, "default.py"))

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def test_w10_the_listing_of_17_lines_runs(self):
        self.assertEqual(self.built.status, 0, self.built.output)
        self.assertEqual(self.built.scene["world"], "syrotek")

    def test_r06_robots_come_from_a_package_of_ones_own(self):
        self.assertEqual(self.built.robots(), ["robot", "s1r_2"])
        self.assertEqual(self.built.robot("robot")["type"], "S1R")
        self.assertEqual(self.built.robot("robot")["pose"], {"x": 1.2, "y": 2.0, "yaw": 2.6})

    def test_r07_the_class_is_named(self):
        self.assertEqual(self.built.objects()["robot"]["properties"]["classpath"],
                         "MorseSyrotek.robots.Syrotek.Syrotek")

    def test_r08_the_keyboard_is_there_to_debug(self):
        children = {name: [child["name"] for child in self.built.objects()[name]["children"]]
                    for name in ("robot", "s1r_2")}
        self.assertIn("robot.keyboard", children["robot"])
        self.assertNotIn("s1r_2.keyboard", children["s1r_2"])

    def test_r09_r13_all_have_the_same_devices(self):
        devices = ["motion", "pose", "hokuyo", "odometry", "robotproperties", "waypoint", "pen"]
        self.assertEqual([name for name in self.built.components("robot") if name != "keyboard"],
                         devices)
        self.assertEqual(self.built.components("s1r_2"), devices)

    def test_r10_r11_r12_the_laser(self):
        hokuyo = self.built.component("robot.hokuyo")
        self.assertEqual(hokuyo["position"], [0.035, 0.0, 0.0])
        self.assertEqual(hokuyo["frequency"], 10.0)
        self.assertEqual(hokuyo["laser"], {
            "range": 5.0, "scan_window_deg": 270.0, "resolution_deg": 0.39589,
            "visible_arc": False, "layers": 1, "layer_separation": 0.8, "layer_offset": 0.125,
            "samples": 682})

    def with_end(self, lines):
        """The project's script with other last lines."""
        with open(os.path.join(self.folder, "MorseSyrotek", "default.py"), encoding="utf-8") as file:
            script = file.read()
        path = os.path.join(self.folder, "MorseSyrotek", "other.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(script + "\n" + lines)
        return Built(path)

    def test_p03_the_canvas_is_a_passive_object_with_the_thesiss_arguments(self):
        built = self.with_end(textwrap.dedent("""\
            import inspect
            print("signature", inspect.signature(Canvas.__init__))
            print("bases", [base.__name__ for base in Canvas.__mro__])
            """))
        self.assertEqual(built.status, 0, built.output)
        self.assertIn("signature (self, filename, alpha=1, prefix=None, keep_pose=False)",
                      built.output)
        self.assertIn("'PassiveObject'", built.output)

    def test_p04_alpha_below_one_is_transparent_and_from_one_on_opaque(self):
        self.assertEqual(self.built.scene["canvas"], {"alpha": 0.75})
        for alpha, wanted in (("1", 1.0), ("3", 1.0), ("0.25", 0.25)):
            with open(os.path.join(self.folder, "MorseSyrotek", "default.py"),
                      encoding="utf-8") as file:
                script = file.read()
            path = os.path.join(self.folder, "MorseSyrotek", "alpha.py")
            with open(path, "w", encoding="utf-8") as file:
                file.write(script.replace("alpha = 0.75", "alpha = " + alpha))
            built = Built(path)
            self.assertEqual(built.status, 0, built.output)
            self.assertEqual(built.scene.get("canvas", {}).get("alpha", 1.0), wanted)

    def test_p06_the_canvass_model_is_no_object_of_the_scene(self):
        # A square plane with a texture in MORSE; here the canvas lies on the floor by itself.
        self.assertNotIn("props", self.built.scene)

    def test_p07_the_canvas_comes_from_the_package_of_components(self):
        built = self.with_end("print('module', Canvas.__module__)\n")
        self.assertIn("module MorseSyrotek.builder.components.canvas", built.output)


class ResourcePath(unittest.TestCase):
    """Models of one's own: by MORSE_RESOURCE_PATH, or by their path."""

    SCRIPT = textwrap.dedent("""\
        from morse.builder import *

        class Rover(Robot):
            def __init__(self, name=None):
                Robot.__init__(self, 'my_project/robots/rover.blend', name)

        rover = Rover()
        env = Environment('empty', fastmode=True)
        """)

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.script = os.path.join(self.folder, "scene.py")
        with open(self.script, "w", encoding="utf-8") as file:
            file.write(self.SCRIPT)

    def tearDown(self):
        shutil.rmtree(self.folder)

    def test_a_robot_from_the_resource_path(self):
        robots = os.path.join(self.folder, "elsewhere", "my_project", "robots")
        os.makedirs(robots)
        with open(os.path.join(robots, "rover.blend"), "wb"):
            pass
        built = Built(self.script, MORSE_RESOURCE_PATH="/nowhere:" +
                      os.path.join(self.folder, "elsewhere"))
        self.assertEqual(built.status, 0, built.output)
        self.assertEqual(built.robots(), ["rover"])
        self.assertEqual(built.robot("rover")["body"]["model"]["file"],
                         os.path.join(robots, "rover.blend"))

    def test_a_model_that_is_nowhere(self):
        built = Built(self.script)
        self.assertEqual(built.status, 1)
        self.assertIn("FileNotFoundError", built.output)
        self.assertIn("my_project/robots/rover.blend", built.output)
        self.assertIn("scene.py\", line 5", built.output)


class EnvironmentFiles(unittest.TestCase):
    """C.4: an environment is a file; the simulator reads it."""

    def built(self, environment):
        folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, folder)
        hall = os.path.join(folder, "hall.blend")
        with open(hall, "wb"):
            pass
        script = os.path.join(folder, "scene.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write("from morse.builder import *\nrobot = ATRV()\nenv = Environment(%r)\n" %
                       environment.replace("FOLDER", folder))
        return hall, Built(script, CCMORSE_MORSE_DATA="")

    def test_c4_a_file_of_ones_own(self):
        hall, built = self.built("FOLDER/hall.blend")
        self.assertEqual(built.status, 0, built.output)
        self.assertEqual(built.scene["world"], {"file": hall, "terrain": True})

    def test_c4_morses_own_where_they_are_installed(self):
        installed = "/usr/share/morse/data/environments/indoors-1/indoor-1.blend"
        _, built = self.built("indoors-1/indoor-1")
        self.assertEqual(built.status, 0, built.output)
        if os.path.exists(installed):
            self.assertEqual(built.scene["world"], {"file": installed, "terrain": True})
        else:
            self.assertTrue(any("is not installed" in text for _, text in built.notes()))


class Package(unittest.TestCase):
    def test_it_needs_the_standard_library_only(self):
        own = {"morse"}
        for folder, _, files in os.walk(os.path.join(PYTHON, "morse")):
            for file in files:
                if not file.endswith(".py"):
                    continue
                with open(os.path.join(folder, file), encoding="utf-8") as text:
                    for line in text:
                        words = line.split()
                        if line.startswith(("import ", "from ")):
                            top = words[1].split(".")[0].rstrip(",")
                            self.assertTrue(top in own or top in sys.stdlib_module_names
                                            if hasattr(sys, "stdlib_module_names") else True,
                                            "%s: %s" % (file, line))


if __name__ == "__main__":
    unittest.main()
