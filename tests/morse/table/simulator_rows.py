"""Tests of the rows that need a run: fields, properties, services and modifiers of what is simulated.

One simulation in lock-step has every component once for each of its levels, each on a robot of its
own, and every modifier. Time stands still but where a row needs it to go on.
"""

import json
import math
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time

from builder_rows import Wrong, check, entry_of, same, value_of, _parameters

SPACING = 14.0  # m between robots
YAW = 0.25  # rad, of all robots
LINES_A_SECOND = 5  # warnings about one stream that are written out


class Scene:
    """A script as MORSE's users write them, with all that the tables name."""

    def __init__(self, tables):
        self.lines = ["from morse.builder import *", ""]
        self.count = 0
        self.parts = {}  # (component, level) -> full name
        self.modified = {}  # id of a modifier's row -> (full name, that of a plain one)
        for row in tables["components.csv"]:
            for level in row["levels"].split():
                self.component(row, level)
        for row in tables["modifiers.csv"]:
            self.modifier(row)
        self.robot("robot", "ATRV")
        self.lines += ["pose = Pose()", "robot.append(pose)", "pose.add_interface('socket')"]
        for name, kind in (("robot2", "ATRV"), ("victim", "Victim"), ("human", "Human"),
                           ("pr2", "BasePR2")):
            self.robot(name, kind)
        self.lines += ["for one in (robot, victim, human, pr2):", "    one.add_service('socket')",
                       "", "env = Environment('empty', fastmode=True)",
                       "env.properties(longitude=1.5, latitude=43.6, altitude=150.0)", ""]

    def robot(self, name, kind):
        x, y = divmod(self.count, 12)
        self.count += 1
        self.lines += ["%s = %s()" % (name, kind),
                       "%s.translate(x=%r, y=%r, z=0.0)" % (name, SPACING * x, SPACING * y),
                       "%s.rotate(z=%r)" % (name, YAW)]

    def part(self, robot, name, row, constructor):
        self.lines += ["%s = %s" % (name, constructor), "%s.append(%s)" % (robot, name)]

    def component(self, row, level):
        name = row["component"]
        robot = "r_%s_%s" % (name, level)
        self.robot(robot, row["robot"])
        on, full = robot, robot + ".part"
        if row["on"]:
            self.lines += ["holder = %s()" % row["on"], "%s.append(holder)" % robot]
            on, full = "holder", robot + ".holder.part"
        if name == "CompoundSensor":
            self.lines += ["eye = Pose()", "%s.append(eye)" % robot]
            self.part(on, "part", row, "CompoundSensor([eye])")
        else:
            self.part(on, "part", row, "%s(%s)" % (name, "'part'" if name == "Kinect" else ""))
        if len(row["levels"].split()) > 1:
            self.lines.append("part.level(%r)" % level)
        if name not in ("Keyboard", "Joystick", "Drag"):
            self.lines.append("part.add_interface('socket')")
        self.parts[name, level] = full

    def modifier(self, row):
        robot = "m%d" % self.count
        self.robot(robot, "ATRV")
        self.lines += ["plain = Pose()", "%s.append(plain)" % robot, "plain.add_service('socket')",
                       "changed = %s()" % row["component"], "%s.append(changed)" % robot]
        name = "classpath=%r" if "." in row["modifier"] else "%r"
        arguments = [name % row["modifier"]] + ([row["parameters"]] if row["parameters"] else [])
        self.lines += ["changed.alter(%s)" % ", ".join(arguments),
                       "changed.add_interface('socket')"]
        self.modified[row["id"]] = (robot + ".changed", robot + ".plain")

    def text(self):
        return "\n".join(self.lines)


class Simulation:
    """ccmorse with a script in lock-step, and one connection to its services."""

    def __init__(self, ccmorse, script, environment):
        self.folder = tempfile.TemporaryDirectory()
        path = os.path.join(self.folder.name, "everything.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(script)
        self.log = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen(
            [ccmorse, "run", path, "--headless", "--port", "0", "--stream-port", "0", "--pace",
             "lockstep"], stdout=self.log, stderr=subprocess.STDOUT, env=environment)
        self.number = 0
        self.socket = None
        until = time.monotonic() + 120.0
        while not (found := re.search(r"MORSE services on \S+ port (\d+)", self.output())):
            if self.process.poll() is not None or time.monotonic() > until:
                self.close()
                raise RuntimeError("no scene:\n" + self.output())
            time.sleep(0.01)
        self.socket = socket.create_connection(("127.0.0.1", int(found.group(1))), 60.0)
        self.socket.settimeout(60.0)
        self.file = self.socket.makefile("r", encoding="utf-8", newline="\n")
        self.answers = {}  # id -> (status, value) of what has been answered and not asked for

    def output(self):
        self.log.seek(0)
        return self.log.read()

    def close(self):
        if self.socket is not None:
            self.socket.close()
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                self.process.kill()
        self.folder.cleanup()

    def start(self, component, service, arguments="[]", name=None):
        """Sends a request; returns its id."""
        self.number += 1
        name = name or "n%d" % self.number
        self.socket.sendall(("%s %s %s %s\n" % (name, component, service, arguments)).encode())
        return name

    def cancel(self, name):
        self.socket.sendall(("%s cancel\n" % name).encode())

    def settle(self):
        """Until all that was sent before has been taken in."""
        self.wait(self.start("ccmorse", "ping"))

    def wait(self, name):
        """(status, value, whether there was one) of a request."""
        while name not in self.answers:
            line = self.file.readline()
            if not line:
                raise RuntimeError("the simulation has ended:\n" + self.output()[-2000:])
            words = line.rstrip("\n").split(" ", 2)
            value = json.loads(words[2]) if len(words) > 2 else None
            self.answers[words[0]] = (words[1], value)
        return self.answers.pop(name)

    def call(self, component, service, arguments="[]"):
        return self.wait(self.start(component, service, arguments))

    def is_pending(self, name):
        self.settle()
        return name not in self.answers


def norm(values):
    return math.sqrt(sum(value * value for value in values))


_KINDS = {
    "float": lambda value: type(value) is float, "double": lambda value: type(value) is float,
    "int": lambda value: type(value) is int, "bool": lambda value: type(value) is bool,
    "string": lambda value: isinstance(value, str), "dict": lambda value: isinstance(value, dict),
    "list": lambda value: isinstance(value, list),
    "list<objects>": lambda value: isinstance(value, list),
    "DDMMYY": lambda value: isinstance(value, str), "HHMMSS": lambda value: isinstance(value, str),
    "buffer": lambda value: isinstance(value, str),
    "memoryview": lambda value: isinstance(value, str),
    "mat3<float>": lambda value: isinstance(value, list),
    "Euler angles (XYZ)": lambda value: isinstance(value, dict) and
    sorted(value) == ["pitch", "roll", "yaw"] and all(type(one) is float
                                                       for one in value.values()),
}


def is_of(kind, value):
    vector = re.fullmatch(r"vec(\d)<float>", kind)
    if vector:
        return (isinstance(value, list) and len(value) == int(vector.group(1)) and
                all(type(one) is float for one in value))
    return _KINDS[kind](value)


def close(given, expected):
    """Equal but for rounding, within what holds others."""
    if isinstance(expected, dict):
        return isinstance(given, dict) and all(close(given.get(key), value)
                                               for key, value in expected.items())
    if isinstance(expected, list):
        return (isinstance(given, list) and len(given) == len(expected) and
                all(close(a, b) for a, b in zip(given, expected)))
    if isinstance(expected, float) and isinstance(given, (int, float)):
        return math.isclose(given, expected, rel_tol=1e-9, abs_tol=1e-6)
    return same(given, expected)


class Runs:
    """What the rows ask of a run, by table."""

    def __init__(self, tables, ccmorse, environment):
        self.tables = tables
        self.scene = Scene(tables)
        self.simulation = Simulation(ccmorse, self.scene.text(), environment)
        self.fields = {}  # component -> its rows
        for row in tables["fields.csv"]:
            self.fields.setdefault(row["component"], []).append(row)
        self.presets = {(row["component"], row["property"]): row["value"]
                        for row in tables["presets.csv"]}
        self.warnings = self.simulation.output()
        self.details = {}
        status, value = self.simulation.call("simulation", "details")
        check(status == "SUCCESS", "simulation details: %s", value)
        for robot in value["robots"]:
            self.details.update(robot["components"])
        self.objects = self.simulation.call("simulation", "get_scene_objects")[1]
        self.first = {}
        names = [name for name, known in self.details.items()
                 if "get_local_data" in known.get("services", [])]
        for name, asked in [(name, self.simulation.start(name, "get_local_data"))
                            for name in names]:
            self.first[name] = self.simulation.wait(asked)[1]
        self.refused = {}  # id of a field's row -> what was wrong with a stream's messages

    def close(self):
        self.simulation.close()

    def is_run(self, name, component, level=None):
        """Is it simulated? Where it is not, the log has said so."""
        if name in self.details and "services" in self.details[name]:
            return True
        entry = entry_of(component)
        if entry["simulated"] and entry["exportable"]:
            check(level not in (None, entry["default_level"]), "the simulation has no %s", name)
        elif not entry["exportable"]:
            return False
        check("%s: the " % name in self.warnings, "no warning says that %s is not simulated",
              name)
        return False

    def truth(self, name):
        """Names for expressions: where the component's robot is."""
        x, y, z = self.objects[name.split(".")[0]][1]
        return {"x": x, "y": y, "z": z, "yaw": YAW, "norm": norm, "inf": math.inf, "pi": math.pi}

    def expect(self, text, value, names, what):
        names["value"] = value
        if text.startswith("?"):
            check(eval(text[1:].strip(), names), "%s is %.200r; not so: %s", what, value, text[2:])
        else:
            expected = eval(text, names)
            check(close(value, expected), "%s is %.200r, not %r", what, value, expected)

    # Components

    def component(self, row):
        entry, status = entry_of(row["component"]), None
        for level in row["levels"].split():
            name = self.scene.parts[row["component"], level]
            if not self.is_run(name, row["component"], level):
                continue
            status = "simulated"
            known = self.details[name]
            implementations = entry["implementations"]
            check(known["type"] == implementations.get(level, implementations.get("default")),
                  "its type is %s at level %s",
                  known["type"], level)
            way = "OUT" if row["kind"] == "sensor" else "IN"
            streams = [way] if entry["exportable"] else []
            check([one[1] for one in known.get("stream_interfaces", [])] == streams,
                  "its streams are %s", known.get("stream_interfaces"))
            common = ["get_configurations", "get_properties", "set_property"]
            common += ["get_local_data"] if row["kind"] == "sensor" else []
            own = [one["name"] for one in entry["services"]]
            missing = set(common + own) - set(known["services"])
            check(not missing, "it has no services %s", sorted(missing))
            check(row["kind"] == "sensor" or "get_local_data" not in known["services"],
                  "an actuator has get_local_data")
            if name in self.first and self.first[name] is not None and row["component"] not in (
                    "CompoundSensor", "Kinect", "ArmaturePose"):
                keys = ["timestamp"] + [one["field"] for one in self.fields.get(
                    row["component"], []) if one["at_start"] != "-" and
                    level in (one["levels"].split() or [level])]
                if "stall" in row["note"] and level == "integrated":
                    keys.append("stall")
                check(list(self.first[name]) == keys, "its data are %s, not %s",
                      list(self.first[name]), keys)
        return status

    # Fields

    def field(self, row):
        entry, status = entry_of(row["component"]), None
        for level in entry["levels"]:
            name = self.scene.parts[row["component"], level]
            if not self.is_run(name, row["component"], level):
                continue
            here = level in (row["levels"].split() or entry["levels"])
            status = "simulated" if here else status
            if entry["kind"] == "actuator":
                self.actuator_field(row)
            elif row["at_start"] == "-" or not here:
                check(row["field"] not in (self.first[name] or {}), "it is there at level %s",
                      level)
            elif self.first[name] is not None:
                self.sensor_field(row, name)
        return status

    def sensor_field(self, row, name):
        known = self.first[name]
        check(row["field"] in known, "the data have no %s: %s", row["field"], list(known))
        value = known[row["field"]]
        check(is_of(row["type"], value), "%.200r is no %s", value, row["type"])
        names = dict(self.truth(name), data=known)
        self.expect(row["at_start"] or row["default"], value, names, row["field"])

    def actuator_field(self, row):
        if not self.refused:
            self.try_streams()
        check(row["id"] in self.refused, "its stream has not been tried")
        check(not self.refused[row["id"]], "%s", self.refused[row["id"]])

    def message(self, rows, name):
        """Data for an actuator that it may well be given: stay where you are."""
        truth, result = self.truth(name), {}
        for row in rows:
            default = value_of(row["default"])
            if isinstance(default, str) and default != "stop" or (
                    row["field"] in ("x", "y", "z", "yaw") and row["component"] in (
                        "Waypoint", "RotorcraftWaypoint")):
                default = truth.get(row["field"], 0.0)
            result[row["field"]] = default
        return result

    def try_streams(self):
        """A message as it is to be, and for each field one where the field is of another type: the
        first is taken in silence, the others are named in the log."""
        streams = []
        for component, rows in self.fields.items():
            entry = entry_of(component)
            name = self.scene.parts[component, entry["default_level"]]
            if entry["kind"] != "actuator" or name not in self.details:
                continue
            for row in rows:
                self.refused[row["id"]] = ""
            status, port = self.simulation.call("simulation", "get_stream_port", '["%s"]' % name)
            if status != "SUCCESS":
                for row in rows:
                    self.refused[row["id"]] = "no stream: %s" % port
                continue
            link = socket.create_connection(("127.0.0.1", port), 60.0)
            streams.append((link, name, rows))
        longest = max((len(rows) for _, _, rows in streams), default=0)
        for number in range(-1, longest):
            if number > 0 and number % (LINES_A_SECOND - 1) == 0:
                time.sleep(1.1)  # more lines than that of one stream are counted, not written
            before = len(self.simulation.output())
            for link, name, rows in streams:
                message = self.message(rows, name)
                if number >= len(rows):
                    continue
                if number >= 0:
                    field = rows[number]["field"]
                    message[field] = 5 if isinstance(message[field], (str, bool)) else "wrong"
                link.sendall((json.dumps(message) + "\n").encode())
            self.simulation.settle()
            for _ in range(2):
                self.simulation.call("ccmorse", "read")
            told = self.simulation.output()[before:]
            for _, name, rows in streams:
                lines = [line for line in told.splitlines()
                         if "%s: a stream message was ignored" % name in line]
                if number < 0:
                    for row in rows:
                        if lines:
                            self.refused[row["id"]] = "a good message: " + lines[0]
                elif number < len(rows) and not any(rows[number]["field"] in line
                                                    for line in lines):
                    self.refused[rows[number]["id"]] = (
                        "the log does not say that %s is of the wrong type: %s" %
                        (rows[number]["field"], lines))
        for link, _, _ in streams:
            link.close()

    # Properties

    def shown(self, name):
        status, value = self.simulation.call(name, "get_properties")
        check(status == "SUCCESS", "get_properties: %s", value)
        return value["properties"]

    def property(self, row):
        entry = entry_of(row["component"])
        name = self.scene.parts[row["component"], entry["default_level"]]
        if not self.is_run(name, row["component"]):
            return None
        known = self.shown(name)
        check(row["property"] in known, "get_properties shows %s only", list(known))
        given = known[row["property"]]
        check(isinstance(given, list) and len(given) == 4 and isinstance(given[1], str) and
              isinstance(given[3], str), "it is shown as %s", given)
        text = self.presets.get((row["component"], row["property"]), row["default"])
        default = value_of(text.replace("robot.part", name))
        if row["component"] == "CompoundSensor":
            default = name.replace(".part", ".eye")
        if default == [] and row["another"]:
            default = ""
        check(same(given[0], default) or close(given[0], default) and type(default) is float,
              "it is %r at the start, not %r", given[0], default)
        if row["another"] == "-":
            status, value = self.simulation.call(
                name, "set_property", json.dumps([row["property"], default]))
            check(status == "FAILED" and "is fixed when the simulation starts" in value,
                  "set_property: %s %s", status, value)
            return "simulated"
        if row["component"] in ("CompoundSensor", "Kinect"):
            return "simulated"
        if row["another"]:
            another = value_of(row["another"])
            another = ",".join(another) if isinstance(another, list) else another
        elif isinstance(default, bool):
            another = not default
        else:
            another = 2.0 if default == math.inf else default + 1 if isinstance(
                default, int) and default < 1000 else 0.5 * default if default else 0.5
        for value in (another, default):
            status, answer = self.simulation.call(
                name, "set_property", json.dumps([row["property"], value]).replace(
                    "Infinity", '"inf"'))
            check(status == "SUCCESS", "set_property to %r: %s", value, answer)
            now = self.shown(name)[row["property"]][0]
            check(close(now, value), "it is %r after it has been set to %r", now, value)
            configurations = self.simulation.call(name, "get_configurations")[1]["configurations"]
            check(close(configurations.get(row["property"]), value),
                  "get_configurations shows %r", configurations.get(row["property"]))
        return "simulated"

    def preset(self, row):
        entry = entry_of(row["component"])
        name = self.scene.parts[row["component"], entry["default_level"]]
        if row["property"] not in entry["properties"] or not self.is_run(name, row["component"]):
            return None
        if row["component"] in ("CompoundSensor", "Kinect"):
            return "simulated"
        known = self.shown(name)
        check(row["property"] in known, "get_properties shows %s only", list(known))
        check(close(known[row["property"]][0], value_of(row["value"])),
              "it is %r at the start", known[row["property"]][0])
        return "simulated"

    # Services

    def service(self, row):
        component = row["component"]
        if component.startswith("*"):
            return self.common_service(row)
        if component in ("simulation", "time", "communication"):
            return self.service_of(row, component)
        robots = {"Victim": "victim", "Human": "human", "BasePR2": "pr2"}
        if component in robots:
            return self.service_of(row, robots[component])
        entry = entry_of(component)
        name = self.scene.parts[component, entry["default_level"]]
        if not self.is_run(name, component):
            return None
        check(row["service"] in self.details[name]["services"], "simulation details has it not")
        return self.service_of(row, name)

    def common_service(self, row):
        kind = row["component"][1:].strip()
        if kind == "robot":
            names = ["robot", "victim", "human", "pr2"]
        else:
            names = []
            for (component, _), name in self.scene.parts.items():
                entry = entry_of(component)
                if name in self.details and "services" in self.details[name] and kind in (
                        "", entry["kind"]):
                    names.append(name)
        check(names, "nobody has it")
        for name in names:
            try:
                self.service_of(row, name)
            except Wrong as wrong:
                raise Wrong("%s: %s" % (name, wrong))
        return "simulated"

    def arity(self, row, name):
        required, optional, _ = _parameters("(%s)" % row["parameters"])
        service = row["service"]
        many = json.dumps([0] * (len(required) + len(optional) + 1))
        status, value = self.simulation.call(name, service, many)
        check(status == "FAILED" and value != "The request %s has not been registered in Socket "
              "service manager" % service, "%s: %s", status, value)
        check(value.startswith("Socket service manager: wrong # of parameters for service %s. "
                               "%s() takes " % (service, service)) and "given" in value,
              "too many parameters are answered %s %s", status, value)
        if required:
            status, value = self.simulation.call(name, service)
            check(status == "FAILED" and value.startswith(
                "Socket service manager: parameters expected for service %s! %s() missing %d "
                "required positional argument" % (service, service, len(required))),
                "no parameters are answered %s %s", status, value)
        if len(required) > 1:
            few = json.dumps([0] * (len(required) - 1))
            status, value = self.simulation.call(name, service, few)
            check(status == "FAILED" and value.startswith(
                "Socket service manager: wrong # of parameters for service %s. %s() missing 1 "
                "required positional argument: '" % (service, service)),
                "too few parameters are answered %s %s", status, value)

    def service_of(self, row, name):
        if row["arguments"] == "-":  # it is there, and what is wrong is answered
            self.arity(row, name)
            return "simulated"
        self.arity(row, name)
        answer = row["answer"].replace("{component}", name)
        place = json.dumps(self.objects.get(name, self.objects["robot"])[1])
        arguments = row["arguments"].replace("{place}", place)
        asked = self.simulation.start(name, row["service"], arguments)
        if answer == "pending":
            return self.asynchronous(row, name, asked)
        if row["kind"].startswith("async") and self.simulation.is_pending(asked):
            self.simulation.cancel(asked)
            self.simulation.settle()
            return "simulated"
        status, value = self.simulation.wait(asked)
        if answer == "any":
            check(status in ("SUCCESS", "FAILED") and "not been registered" not in str(value) and
                  "parameter" not in str(value), "answered %s %s", status, value)
        elif answer.startswith("FAILED"):
            check(status == "FAILED" and str(value).startswith(answer[7:]), "answered %s %s",
                  status, value)
        else:
            check(status == "SUCCESS", "answered %s %s", status, value)
            text = {"": "None", "true": "True", "null": "None"}.get(answer, answer)
            self.expect(text, value, {"norm": norm}, "the answer")
        return "simulated"

    def asynchronous(self, row, name, asked):
        check(self.simulation.is_pending(asked), "answered at once: %s",
              self.simulation.answers.get(asked))
        again = self.simulation.start(name, row["service"], row["arguments"])
        if row["kind"].endswith("interruptible"):
            status, _ = self.simulation.wait(asked)
            check(status == "PREEMPTED", "a second call answers the first one %s", status)
            check(self.simulation.is_pending(again), "the second call is answered at once")
            self.simulation.cancel(again)
            status, _ = self.simulation.wait(again)
            check(status == "PREEMPTED", "cancel answers it %s", status)
        else:
            status, value = self.simulation.wait(again)
            check(status == "FAILED" and value == "A service (%s) is already running. I do not "
                  "know what to do." % row["service"], "a second call is answered %s %s", status,
                  value)
            self.simulation.cancel(asked)
            if name == "time":
                check(self.simulation.is_pending(asked), "cancel ends it")
        return "simulated"

    # Modifiers

    def modifier(self, row):
        name, plain = self.scene.modified[row["id"]]
        if "%s: the component " % name in self.warnings:
            return None
        if "%s: the modifier %s is not simulated" % (name, row["modifier"]) in self.warnings:
            return None
        check(name in self.details, "the simulation has no %s", name)
        check("%s: the " % name not in self.warnings, "the log has a warning about it")
        if row["effect"]:
            true = self.first[plain]
            names = dict(self.truth(name), x=true["x"], y=true["y"], z=true["z"], yaw=true["yaw"])
            self.expect(row["effect"], self.first[name], names, "what it shows")
        return "simulated"
