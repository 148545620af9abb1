"""What components of one's own import and what is read of their classes (docs/components.md)."""

import math
import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))

from morse.core import describe  # noqa: E402
from morse.core.host import place_of, text_of  # noqa: E402
from morse.core.overlay import MorseOverlay, OverlaidComponent, OverlaidOwn  # noqa: E402
from morse.core.exceptions import MorseRPCInvokationError  # noqa: E402
from morse.core.services import async_service, interruptible, service  # noqa: E402
from morse.core.abstractobject import AbstractObject  # noqa: E402
from morse.core.mathutils import Euler, Matrix, Quaternion, Vector  # noqa: E402
from morse.helpers.transformation import Transformation3d  # noqa: E402

MODULE = """
import morse.core.sensor
from morse.core.services import service, async_service, interruptible
from morse.helpers.components import add_data, add_level, add_property

class Base(morse.core.sensor.Sensor):
    add_data('both', 1.5, 'float', '')
    add_data('changed', 1, 'int', '')
    add_property('_a', 1.0, 'A')

class Thing(Base):
    add_level('simple', None, 'the plain one', True)
    add_level('fine', 'of_test.Fine')
    add_data('changed', 'text', 'string', '')
    add_data('rough', 0, 'int', '', level='simple')
    add_data('exact', float('inf'), 'float', '', level=['fine'])
    add_property('_b', 'x', 'B')
    @service
    def get(self, name, default=None):
        pass
    @interruptible
    @async_service
    def go(self):
        pass
    @service(name='other_name')
    def named(self):
        pass

class Fine(Thing):
    pass
"""


class Describing(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        with open(os.path.join(cls.folder.name, "of_test.py"), "w", encoding="utf-8") as file:
            file.write(MODULE)
        sys.path.insert(0, cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        sys.path.remove(cls.folder.name)
        cls.folder.cleanup()

    def test_data_of_the_level_and_of_base_classes_in_order(self):
        cls, simple = describe.describe("of_test.Thing")
        self.assertEqual(simple["level"], "simple")
        self.assertEqual(list(simple["data"].items()),
                         [("both", 1.5), ("changed", "text"), ("rough", 0)])
        self.assertEqual(simple["properties"], {"A": 1.0, "B": "x"})
        self.assertEqual(describe.source_folder(cls), os.path.abspath(self.folder.name))

    def test_a_level_has_its_own_class_and_fields(self):
        cls, fine = describe.describe("of_test.Thing", "fine")
        self.assertEqual(cls.__name__, "Fine")
        self.assertEqual(fine["code"], "of_test.Fine")
        self.assertEqual(fine["data"], {"both": 1.5, "changed": "text", "exact": None})

    def test_services_have_their_parameters(self):
        services = {one["name"]: one for one in describe.describe("of_test.Thing")[1]["services"]}
        self.assertEqual(sorted(services), ["get", "go", "other_name"])
        self.assertEqual(services["get"]["parameters"],
                         [{"name": "name", "optional": False}, {"name": "default", "optional": True}])
        self.assertTrue(services["go"]["asynchronous"])
        self.assertFalse(services["get"]["asynchronous"])


class Sending(unittest.TestCase):

    def test_values_are_sent_as_morse_does(self):
        self.assertEqual(text_of({"v": Vector((1.0, 2.0)), "m": Matrix([[1, 0], [0, 1]])}),
                         '{"v": [1.0, 2.0], "m": [[1, 0], [0, 1]]}')
        self.assertEqual(text_of(Euler((1.0, 2.0, 3.0))), '{"yaw": 3.0, "pitch": 2.0, "roll": 1.0}')
        self.assertEqual(text_of(Quaternion((1.0, 2.0, 3.0, 4.0))),
                         '{"x": 2.0, "y": 3.0, "z": 4.0, "w": 1.0}')
        self.assertEqual(text_of((float("inf"), None, True)), "[Infinity, null, true]")
        with self.assertRaisesRegex(TypeError, "a object cannot be sent"):
            text_of(object())

    def test_an_error_is_where_the_user_made_it(self):
        try:
            Transformation3d.of([1.0], None)
        except TypeError as error:
            self.assertIn(os.path.basename(__file__), place_of(error))


class Places(unittest.TestCase):

    def assertPose(self, made, expected):
        found = (made.x, made.y, made.z, made.roll, made.pitch, made.yaw)
        for one, other in zip(found, expected):
            self.assertAlmostEqual(one, other, 12)

    def test_a_mount_on_a_turned_robot(self):
        robot = Transformation3d.of((1.0, 2.0, 0.5), (0.0, 0.0, math.pi / 2))
        mount = Transformation3d.of((0.3, 0.1, 0.2), (0.0, 0.4, 0.0))
        self.assertPose(robot.times(mount), (0.9, 2.3, 0.7, 0.0, 0.4, math.pi / 2))
        self.assertPose(robot.transformation3d_with(robot.times(mount)), (0.3, 0.1, 0.2, 0, 0.4, 0))

    def test_euler_angles_come_back(self):
        for angles in ((0.1, 0.2, 0.3), (-3.0, -1.5, 3.1), (1.0, 0.0, -2.0)):
            self.assertPose(Transformation3d.of((0, 0, 0), angles), (0, 0, 0) + angles)

    def test_distances(self):
        here = Transformation3d.of((0.0, 0.0, 0.0), (0, 0, 0))
        there = Transformation3d.of((3.0, 4.0, 12.0), (0, 0, 0))
        self.assertEqual(here.distance(there), 13.0)
        self.assertEqual(here.distance_2d(there), 5.0)


class Asked:
    """Stands for the simulator that an overlay's questions go to."""

    def __init__(self, answers):
        self.questions, self.answers, self.callbacks = [], list(answers), {}

    def ask(self, question):
        self.questions.append(question)
        return self.answers.pop(0)

    def keep(self, callback):
        self.callbacks[7] = callback
        return 7


class Guide(MorseOverlay):
    @interruptible
    @async_service
    def walk(self, x):
        self.overlaid_object.goto(self.chain_callback(self.changed), x)

    @async_service
    def plain(self, x):
        self.overlaid_object.goto(self.chain_callback(), x)

    def changed(self, result):
        if result[1] == "worse":
            raise ValueError("too bad")
        return result[0], [result[1], "changed"]


class Overlays(unittest.TestCase):

    def make(self, *answers):
        asked = Asked(answers)
        birth = {"name": "robot.motion", "overlay": "key", "services": {"goto": True, "stop": False}}
        return Guide(OverlaidComponent(birth, None, asked)), asked

    def test_a_service_that_answers_at_once(self):
        guide, asked = self.make({"result": 3}, {"failed": "no"})
        self.assertEqual(guide.name(), "Guide")
        self.assertEqual(guide.overlaid_object.stop(1, 2), 3)
        self.assertEqual(asked.questions, [["robot.motion", "stop", [1, 2]]])
        with self.assertRaisesRegex(MorseRPCInvokationError, "^no$"):
            guide.overlaid_object.stop()
        with self.assertRaisesRegex(AttributeError, "robot.motion has no service 'fly'"):
            guide.overlaid_object.fly()

    def test_a_chained_service_ends_with_the_components(self):
        guide, asked = self.make({"later": True}, {"later": True}, {"ended": ["SUCCESS", "now"]})
        guide._begin(guide.walk, [2.0], 41)
        self.assertEqual(asked.questions, [["robot.motion", "goto", [2.0], "key", 7]])
        self.assertEqual(guide._ended, [])
        asked.callbacks.pop(7)(("SUCCESS", 5))
        self.assertEqual(guide._ended, [[41, "SUCCESS", [5, "changed"]]])
        guide._ended = []
        guide._begin(guide.walk, [2.0], 42)
        with self.assertLogs("morse.Guide"):
            asked.callbacks.pop(7)(("SUCCESS", "worse"))
        self.assertEqual(guide._ended, [[42, "FAILED", "ValueError: too bad"]])
        guide._ended = []
        guide._begin(guide.plain, [2.0], 43)  # at once
        self.assertEqual((guide._ended, asked.callbacks), ([[43, "SUCCESS", "now"]], {}))

    def test_what_was_preempted_does_not_end_what_came_after(self):
        guide, asked = self.make({"later": True}, {"result": None}, {"later": True})
        guide._begin(guide.walk, [2.0], 1)
        first = asked.callbacks.pop(7)
        guide._begin(guide.walk, [3.0], 2)
        self.assertEqual(asked.questions[1], ["", "interrupt", ["robot.motion"]])
        first(("PREEMPTED", None))
        self.assertEqual(guide._ended, [[1, "PREEMPTED", None]])
        asked.callbacks.pop(7)(("SUCCESS", 1))
        self.assertEqual(guide._ended[1:], [[2, "SUCCESS", [1, "changed"]]])

    def test_a_start_that_fails_leaves_nothing(self):
        guide, asked = self.make({"failed": "busy"})
        with self.assertRaisesRegex(MorseRPCInvokationError, "busy"):
            guide._begin(guide.plain, [1.0], 1)
        self.assertEqual((asked.callbacks, guide.on_completion), ({}, None))
        with self.assertRaisesRegex(TypeError, "chain_callback"):
            guide.overlaid_object.goto(1.0)

    def test_on_a_component_of_ones_own(self):
        class Thing(AbstractObject):
            number = 4

            @service
            def get(self, plus):
                return self.number + plus

            @interruptible
            @async_service
            def go(self, x):
                self.number = x

        thing = Thing()
        overlaid = OverlaidOwn(thing, describe.services_of(Thing))
        self.assertEqual(overlaid.get(1), 5)
        overlaid.number = 6
        self.assertEqual((thing.number, overlaid.number), (6, 6))
        callback = lambda result: None  # noqa: E731
        overlaid.go(callback, 9)
        self.assertEqual((thing.number, thing.on_completion), (9, (callback, "go")))
        thing.completed("SUCCESS", 1)
        self.assertEqual(thing._ended, [[callback, "SUCCESS", 1]])


if __name__ == "__main__":
    unittest.main()
