"""The process in which components of one's own run: python3 -m morse.core.host

The simulator starts it and talks with it over file descriptor 3, a JSON object a line: first the
scene, then for each tick that something is due in the tasks, each of which is answered in a line.
What a component raises ends that component only. One that takes too long gets an exception where it
is; if that does not help, the simulator ends the process and starts another one without it.
Descriptor 4 takes Python's last words of where it was.
"""

import faulthandler
import json
import logging
import math
import os
import random
import signal
import sys
import traceback

_SOCKET = 3
_TRACE = 4
_OURS = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


class Hang(BaseException):
    """A component has taken too long. Not for it to catch."""


class Line:
    """The other end: lines of JSON."""

    def __init__(self, descriptor):
        self._descriptor = descriptor
        self._bytes = b""

    def read(self):
        """The next object; None at the end."""
        while b"\n" not in self._bytes:
            block = os.read(self._descriptor, 65536)
            if not block:
                return None
            self._bytes += block
        line, _, self._bytes = self._bytes.partition(b"\n")
        return json.loads(line)

    def write(self, text):
        text = text.encode() + b"\n"
        while text:
            text = text[os.write(self._descriptor, text):]


class Stopwatch:
    """Raises Hang in code that takes too long."""

    _AGAIN = 0.05  # s: for code that swallows it

    def __init__(self, limit):
        self.limit = limit
        self._armed = False
        signal.signal(signal.SIGALRM, self._ring)

    def _ring(self, _number, _frame):
        if self._armed:
            raise Hang()

    def __enter__(self):
        self._armed = True
        signal.setitimer(signal.ITIMER_REAL, self.limit, self._AGAIN)

    def __exit__(self, *_):
        self._armed = False
        signal.setitimer(signal.ITIMER_REAL, 0.0)


class State:
    """What the components share."""

    def __init__(self, line):
        self.line = line
        self.time = 0.0
        self.poses = {}
        self.deeds = []  # None: what runs does none
        self.callbacks = {}  # number -> what is called when another component's service ends
        self._numbers = 0
        self.live = False  # the simulation runs, and may be asked

    def add(self, what):
        """Something to be done to the world."""
        if self.deeds is None:
            raise RuntimeError("an overlay of the simulator's own component does nothing to the "
                               "world itself; call services")
        self.deeds.append(what)

    def keep(self, callback):
        self._numbers += 1
        self.callbacks[self._numbers] = callback
        return self._numbers

    def ask(self, question):
        if not self.live:
            raise RuntimeError("other components can be called once the simulation runs, not in "
                               "__init__()")
        self.line.write(text_of({"ask": question}))
        return self.line.read()


def deed(name, *numbers):
    """Something to be done to the world. Raises ValueError and TypeError in the user's code."""
    for number in numbers:
        if not math.isfinite(number):
            raise ValueError("%s needs finite numbers, not %r" % (name, number))
    return [name, *(number if isinstance(number, int) else float(number) for number in numbers)]


class Canvas:
    """The grid map: cells, (0, 0) at the world's bottom-left corner, x right, y up."""

    def __init__(self, state, size, world):
        self._state = state
        self._world, self._low = world[:2], world[2:]
        self.width, self.height = size

    @property
    def cell_size(self):
        """m"""
        return max(self._world[0] / self.width, self._world[1] / self.height)

    def cell_at(self, x, y):
        """The cell of a place in the world, m."""
        return (math.floor((x - self._low[0]) / self.cell_size),
                math.floor((y - self._low[1]) / self.cell_size))

    def set_pixel(self, x, y, color, alpha=1.0):
        """Draws a cell: red, green, blue of 0..255; alpha 0..1."""
        self._state.add(deed("pixel", x, y, *color[:3], alpha))

    def draw_line(self, x0, y0, x1, y1, color, alpha=1.0):
        """Draws the cells of a straight line, both ends included."""
        self._state.add(deed("line", x0, y0, x1, y1, *color[:3], alpha))

    def clear(self):
        self._state.add(deed("clear"))

    def resize(self, width, height):
        """A new resolution, 1..4096 cells each way; the canvas is clear then."""
        self._state.add(deed("resize", width, height))
        self.width, self.height = width, height

    def get_pixel(self, x, y):
        """[red, green, blue] as it was before this call of the component's code; None outside."""
        return self._state.ask(["canvas", "get_pixel", [x, y]]).get("result")


class Body:
    """What stands for Blender's object of a robot or a component."""

    def __init__(self, name, state):
        self.name = name
        self._state = state

    def __getattr__(self, name):
        raise AttributeError("there is no Blender behind %s, so its bge_object has no %r; see "
                             "docs/components.md" % (self.name, name))


class RobotBody(Body):
    def __init__(self, name, state, facts):
        super().__init__(name, state)
        self.facts = facts

    @property
    def time(self):
        return self._state.time

    @property
    def pose(self):
        return self._state.poses[self.name]

    @property
    def worldPosition(self):  # pylint: disable=invalid-name
        return self.pose[:3]

    def do(self, *words):
        self._state.add(deed(*words))

    def __getitem__(self, name):
        return self.facts["properties"][name]

    def get(self, name, default=None):
        return self.facts["properties"].get(name, default)


class ComponentBody(Body):
    def __init__(self, birth, state, canvas):
        super().__init__(birth["name"], state)
        self.canvas = canvas
        self.frequency = birth["frequency"]
        self.level = birth["level"]
        self.mount = birth["mount"]
        self.mount_euler = birth["mount_euler"]
        self.properties = birth["properties"]

    def ask(self, question):
        return self._state.ask(question)


def plain(value):
    """What MORSE sends for what JSON has not."""
    if isinstance(value, (set, frozenset, tuple)):
        return list(value)
    # Both Blender's own and ours.
    kind = type(value).__name__
    if kind == "Quaternion":
        return {"x": value.x, "y": value.y, "z": value.z, "w": value.w}
    if kind == "Transformation3d":
        return {name: getattr(value, name) for name in ("x", "y", "z", "yaw", "pitch", "roll")}
    if kind in ("float64", "float32", "int64", "int32", "bool_"):  # of numpy
        return value.item()
    if kind == "ndarray":
        return value.tolist()
    if isinstance(value, bytes):
        return value.decode("latin-1")
    raise TypeError("a %s cannot be sent to clients; use numbers, texts, lists and dicts" % kind)


def eulers(value):
    """MORSE sends Euler angles by name; being lists to Python's json they are looked for."""
    from morse.core.mathutils import Euler
    if isinstance(value, Euler):
        return {"yaw": value.z, "pitch": value.y, "roll": value.x}
    if isinstance(value, dict):
        return {key: eulers(item) for key, item in value.items()}
    if isinstance(value, list):
        return [eulers(item) for item in value]
    return value


def text_of(value):
    return json.dumps(eulers(value), default=plain)


def place_of(error):
    """ "FILE:LINE: in NAME: " of the innermost frame that is the user's."""
    frames = [frame for frame in traceback.extract_tb(error.__traceback__)
              if not os.path.abspath(frame.filename).startswith(_OURS + os.sep) and
              not frame.filename.startswith("<")]
    if isinstance(error, SyntaxError) and error.filename:
        return "%s:%s: " % (error.filename, error.lineno)
    # The innermost one that is not of Python's own library, where there is one.
    library = os.path.dirname(os.__file__)
    own = [frame for frame in frames if not frame.filename.startswith(library + os.sep)] or frames
    return "%s:%d: in %s: " % (own[-1].filename, own[-1].lineno, own[-1].name) if own else ""


def place_of_method(component):
    """ "FILE:LINE: " of its default action, for what ends without any words."""
    code = getattr(getattr(type(component), "default_action", None), "__code__", None)
    return "%s:%d: " % (code.co_filename, code.co_firstlineno) if code else ""


def words_of(error):
    return "".join(traceback.format_exception_only(type(error), error)).strip().splitlines()[-1]


class Host:
    """All components and their robots."""

    def __init__(self, line):
        from morse.core import describe
        from morse.core.robot import Robot
        self.line = line
        self.state = State(line)
        self.components = {}
        self.overlays = {}
        self.overlaid = {}  # key of an overlay -> the name of a component that runs here, too
        self.sent = {}  # name -> local_data as the simulator knows them, as text
        scene = line.read()
        if scene is None:
            sys.exit(0)
        random.seed(scene["seed"])
        self.state.time, self.state.poses = scene["time"], scene["poses"]
        self.watch = Stopwatch(scene["start_limit"])
        self.describe = describe
        self.canvas = Canvas(self.state, scene["canvas"], scene["world"])
        self.robots = {name: Robot(RobotBody(name, self.state, facts))
                       for name, facts in scene["robots"].items()}
        for birth in scene["components"] + scene["overlays"]:
            for folder in reversed(birth["path"]):
                if folder not in sys.path:
                    sys.path.insert(0, folder)
        for birth in scene["components"]:
            self.answer(lambda birth=birth: self.make(birth), birth["name"])
        for birth in scene["overlays"]:
            self.answer(lambda birth=birth: self.overlay(birth), birth["overlay"])
        self.watch.limit = scene["limit"]
        self.state.live = True

    def make(self, birth):
        cls = self.describe.load(birth["class"])
        component = cls(ComponentBody(birth, self.state, self.canvas), self.robots[birth["robot"]])
        if not hasattr(component, "local_data"):
            raise TypeError("%s.__init__() must call that of its base class" % cls.__name__)
        name = birth["name"]
        self.components[name] = component
        self.sent[name] = text_of(birth["data"])
        if birth["anew"]:  # the process before this one has ended over another component
            component.local_data.update(birth["data"])
        return {"at": place_of_method(component)}

    def overlay(self, birth):
        from morse.core import overlay
        cls = self.describe.load(birth["class"])
        component = self.components.get(birth["name"])
        if component is None:
            overlaid = overlay.OverlaidComponent(birth, self.robots[birth["robot"]], self.state)
        else:
            overlaid = overlay.OverlaidOwn(component, self.describe.services_of(type(component)))
        made = cls(overlaid, **birth["settings"])
        if not hasattr(made, "overlaid_object"):
            raise TypeError("%s.__init__() must call that of its base class" % cls.__name__)
        name = made.name()
        if not isinstance(name, str):
            raise TypeError("%s.name() must be a text, not %r" % (cls.__name__, name))
        self.overlays[birth["overlay"]] = made
        if component is not None:
            self.overlaid[birth["overlay"]] = birth["name"]
        return {"name": name}

    def settle(self):
        """Tells overlays which services of components in this process have ended."""
        for component in list(self.components.values()):
            own = [one for one in component._ended if callable(one[0])]
            component._ended = [one for one in component._ended if not callable(one[0])]
            for callback, status, result in own:
                callback((status, result))

    def abandon(self, component):
        """Tells them what has become of a component that is off."""
        ends, running = component._ended, component._running
        component._ended, component._running = [], None
        if running is not None:
            ends = ends + [[running[0], "FAILED", component.name() +
                            " was switched off: its code has failed"]]
        for callback, status, result in ends:
            if callable(callback):
                callback((status, result))

    def other_ends(self):
        """Services that have ended beside those of the component that has just run."""
        ends = []
        for each in [*self.components.values(), *self.overlays.values()]:
            for end in each._ended:
                try:
                    text_of(end)
                except (TypeError, ValueError, RecursionError) as error:
                    end = [end[0], "FAILED", words_of(error)]
                ends.append(end)
            each._ended = []
        return ends

    def answer(self, work, name):
        """Has something done and answers what came of it."""
        self.state.deeds = []
        answer = {}
        try:
            try:
                with self.watch:
                    answer = work()
                    self.settle()
            finally:
                sys.stdout.flush()
        except Hang as hang:
            answer = {"off": place_of(hang) + "it has not ended after %g s of wall-clock time" %
                             self.watch.limit}
        except BaseException as error:  # whatever it raises is its own end only
            answer = {"off": place_of(error) + words_of(error)}
        # What an overlay has done to the data of a component that runs here is seen at once.
        of = self.overlaid.get(name, name)
        component = self.components.get(of)
        change = {}
        if self.state.deeds:
            change["do"] = self.state.deeds
        try:
            if component is not None and "off" not in answer:
                text = text_of(component.local_data)
                if text != self.sent[of]:
                    change["data"] = json.loads(text)
                    if not isinstance(change["data"], dict):
                        raise TypeError("local_data must be a dict")
                    self.sent[of] = text
                if component._ended:
                    answer["ended"] = component._ended
                    component._ended = []
            if change and "off" not in answer:
                answer["change"] = change
            answer_text = text_of(answer)
        except (TypeError, ValueError, RecursionError) as error:
            answer = {"off": place_of_method(component) + words_of(error)}
            answer_text = text_of(answer)
        if "off" in answer:
            self.overlays.pop(name, None)
            if self.components.pop(name, None) is not None:  # not that of an overlay
                self.abandon(component)
        ends = self.other_ends()
        if ends:
            answer["ended"] = answer.get("ended", []) + ends
            answer_text = text_of(answer)
        self.line.write(answer_text)

    def perform(self, task):
        component = self.components.get(task.get("o", task["n"]))
        if component is not None:
            if "d" in task:
                component.local_data = task["d"]
                self.sent[component.name()] = text_of(task["d"])
            if "p" in task:
                component._set_properties(task["p"])
        kind = task["k"]
        if task["n"] in self.overlays:
            if component is None:
                self.state.deeds = None
            component = self.overlays[task["n"]]
        elif task["n"] not in self.components:
            return {}
        if kind == "ended":
            callback = self.state.callbacks.pop(task["i"], None)
            if callback is not None:
                callback(tuple(task["r"]))
            return {}
        if kind == "act":
            component.action()
            return {}
        if kind == "interrupt":
            component.interrupt()
            component.completed("PREEMPTED")  # where interrupt() has not
            return {}
        return self.serve(component, task)

    def serve(self, component, task):
        """A service that fails has failed, and that is all."""
        from morse.core.exceptions import MorseError
        method = getattr(component, self.describe.services_of(type(component))[task["s"]].__name__)
        try:
            if task["k"] == "start":
                component._begin(method, task["a"], task["t"])
                return {}
            result = method(*task["a"])
            return {"result": json.loads(text_of(result))}
        except MorseError as error:
            return {"failed": str(error)}
        except TypeError as error:
            text = place_of(error) + words_of(error)
            return {"wrong": str(error), "error": "%s (in the service %s)" % (text, task["s"])}
        except Exception as error:
            text = place_of(error) + words_of(error)
            return {"failed": text, "error": text + " (in the service %s)" % task["s"]}

    def run(self):
        while True:
            message = self.line.read()
            if message is None:
                break
            self.state.time = message["time"]
            self.state.poses.update(message["poses"])
            for task in message["tasks"]:
                self.answer(lambda task=task: self.perform(task), task["n"])
        for component in self.components.values():
            component.finalize()


def main():
    faulthandler.enable(file=_TRACE, all_threads=False)
    for descriptor in (_SOCKET, _TRACE):
        os.set_inheritable(descriptor, False)  # not for what components start
    logging.basicConfig(level=logging.INFO, stream=sys.stderr,
                        format="[%(levelname)s][%(name)s] %(message)s")
    # The module that runs as __main__ is the one that components would import.
    sys.modules["morse.core.host"] = sys.modules["__main__"]
    Host(Line(_SOCKET)).run()


if __name__ == "__main__":
    main()
