"""Tests of the rows that need the builder alone: its classes, methods and attributes."""

import ast
import contextlib
import importlib
import inspect
import io
import logging
import math
import os
import sys
import tempfile

import morse.builder as builder
from morse.builder import bpymorse, data, places, scene
from morse.builder.abstractcomponent import AbstractComponent, Configuration
from morse.builder.environment import Environment
from morse.core.morse_time import TimeStrategies


class Wrong(Exception):
    """What a row promises is not so."""


def check(so, text, *values):
    if not so:
        raise Wrong(text % values if values else text)


def forget():
    """Back to a script's first line."""
    del AbstractComponent.components[:]
    del places.notes[:]
    bpymorse.reset()
    Configuration.reset()
    Environment.current = None


class Log(logging.Handler):
    """Lines "LEVEL text"."""

    def __init__(self):
        super().__init__()
        self.lines = []

    def emit(self, record):
        self.lines.append("%s %s" % (record.levelname, record.getMessage()))


def _parameters(text):
    """Those of a signature as the table has it, without the one for the object."""
    function = ast.parse("def f%s: pass" % text).body[0]
    names = [argument.arg for argument in function.args.args]
    defaults = [ast.literal_eval(value) for value in function.args.defaults]
    required = len(names) - len(defaults)
    return names[:required], dict(zip(names[required:], defaults)), bool(function.args.kwarg)


# In the specification's words -> in MORSE's code and ours: only what is often given by name.
_NAMES = {"start": "clip_start", "end": "clip_end", "g": "gravity", "path": "filepath",
          "base": "base_frequency"}


def check_signature(function, text, bound):
    """Can it be called as MORSE's can? Parameters with a default have MORSE's names and values."""
    required, optional, more = _parameters(text)
    ours = list(inspect.signature(function).parameters.values())
    if not bound:
        ours = ours[1:]
    arguments = [one for one in ours if one.kind == one.POSITIONAL_OR_KEYWORD]
    wide = any(one.kind == one.VAR_POSITIONAL for one in ours)
    check(len(arguments) >= len(required) or wide, "it takes %d arguments, not %d: %s",
          len(arguments), len(required), inspect.signature(function))
    for one in arguments[len(required):]:
        check(one.default is not one.empty, "%s must be given: %s", one.name,
              inspect.signature(function))
    if more:
        check(any(one.kind == one.VAR_KEYWORD for one in ours), "takes no others: %s",
              inspect.signature(function))
    known = {one.name: one.default for one in ours}
    for name, value in optional.items():
        name = name if name in known else _NAMES.get(name, name)
        check(name in known, "has no parameter %s: %s", name, inspect.signature(function))
        check(same(known[name], value), "%s is %r where it is not given, not %r", name, known[name],
              value)


def _callable_of(row):
    owner, name = row["owner"], row["name"].split(" ")[0]
    if row["kind"] == "class":
        module = importlib.import_module(owner)
        return getattr(module, name), True
    if row["kind"] == "function":
        return getattr(bpymorse, name), True
    known = TimeStrategies if owner == "TimeStrategies" else getattr(builder, owner)
    function = getattr(known, name)
    held = inspect.getattr_static(known, name)
    return function, isinstance(held, (staticmethod, classmethod))


class Stage:
    """One row's script: a robot with a pose sensor, what the row does, and what comes of it."""

    def __init__(self, row):
        self.row = row
        self.folder = None
        self.log = Log()
        self.stderr = io.StringIO()
        self.names = {}

    def run(self):
        forget()
        self.names = {"inspect": inspect, "importlib": importlib, "os": os, "near": near,
                      "file": self.file, "error": None, "geodesy": False}
        logger = logging.getLogger()
        logger.addHandler(self.log)
        try:
            with contextlib.redirect_stderr(self.stderr):
                self.play()
        finally:
            logger.removeHandler(self.log)
            if self.folder is not None:
                self.folder.cleanup()

    def play(self):
        owner = self.row["owner"]
        self.script("from morse.builder import *\nrobot = ATRV()\npose = Pose()\n"
                    "robot.append(pose)")
        if owner == "Environment" and self.row["kind"] == "method":
            self.script("env = Environment('empty')")
        try:
            self.script(self.row["call"])
        except (Exception, SystemExit) as error:  # the row says which one there is to be
            self.names["error"] = error
        error = self.names["error"]
        check(error is None or "error" in self.row["effect"], "%s: %s", type(error).__name__,
              error)
        if error is None:
            self.build()
        self.names["log"] = "\n".join(self.log.lines) + self.stderr.getvalue()
        so = eval(compile(self.row["effect"], "effect", "eval"), self.names)
        check(so, "not so: %s", self.row["effect"])

    def build(self):
        # Robots that a row makes beside the first would stand in it: only names matter there.
        if Environment.current is None:
            self.script("env = Environment('empty')")
        if self.names["geodesy"]:
            self.script("env.properties(longitude=1.5, latitude=43.6, altitude=150.0)")
        built = scene.build()
        described = {}

        def collect(items):
            for item in items:
                described[item["name"]] = item
                collect(item.get("children", []))

        collect(built["description"]["objects"])
        robots = {robot["name"]: robot for robot in built["scene"]["robots"]}
        parts = {part["name"]: part for part in built["scene"]["robots"][0]["components"]}
        self.names.update(
            S=built["scene"], settings=built["description"]["environment"],
            notes=[note["text"] for note in built["notes"]], described=described.__getitem__,
            part=parts.__getitem__, robot_of=robots.__getitem__)

    def script(self, text):
        exec(compile(text, os.path.join(os.sep, "rows", self.row["id"] + ".py"), "exec"),
             self.names)

    def file(self, name):
        """A model file of the user's own, empty."""
        self.folder = self.folder or tempfile.TemporaryDirectory()
        path = os.path.join(self.folder.name, name)
        with open(path, "wb"):
            pass
        return path


def near(given, expected):
    return len(given) == len(expected) and all(
        math.isclose(a, b, abs_tol=1e-9) for a, b in zip(given, expected))


def check_builder_row(row):
    if row["signature"]:
        function, bound = _callable_of(row)
        if row["kind"] == "class":
            bound = True
        check_signature(function, row["signature"], bound)
    Stage(row).run()
    return "builder"


# What components.json, of which classes, scenes and documentation are made, has of them.

def entry_of(name):
    check(name in data.COMPONENTS, "components.json has no %s", name)
    return data.COMPONENTS[name]


def value_of(text):
    """A default of the table's as Python has it."""
    return math.inf if text == "inf" else ast.literal_eval(text)


def same(given, expected):
    if isinstance(given, bool) or isinstance(expected, bool):
        return given is expected
    if expected == math.inf:
        return given in (math.inf, "inf", "Infinity")
    if isinstance(given, (int, float)) and isinstance(expected, (int, float)):
        return math.isclose(given, expected, rel_tol=1e-7)
    return given == expected


def status_of(entry):
    """What is to be expected of it in a run."""
    if entry["simulated"]:
        return "simulated"
    return entry["needs"] or "accepted"


def make(name):
    forget()
    made = getattr(builder, name)
    if name == "CompoundSensor":
        return made([])
    return made()


def check_component_entry(row):
    name, entry = row["component"], entry_of(row["component"])
    module = importlib.import_module("morse.builder.%ss" % row["kind"])
    made = make(name)
    check(type(made) is getattr(module, name) is getattr(builder, name), "there are two %s", name)
    check(entry["kind"] == row["kind"], "it is a %s", entry["kind"])
    check(made.property_value("classpath") == row["class"], "its class is %s",
          made.property_value("classpath"))
    check(made.rate == float(row["rate"]), "its rate is %s Hz", made.rate)
    check(entry["levels"] == row["levels"].split(), "its levels are %s", entry["levels"])
    check(entry["default_level"] == row["default_level"], "its default level is %s",
          entry["default_level"])
    check(made._bpy_object.game.physics_type == "NO_COLLISION", "it has a body")
    check(made.is_exportable() != (name in ("Keyboard", "Joystick", "Drag")),
          "is_exportable() is %s", made.is_exportable())
    named = builder.CompoundSensor([], "a_name") if name == "CompoundSensor" else getattr(
        builder, name)("a_name")
    check(named.basename == "a_name", "its constructor takes no name")


def check_field_entry(row):
    entry = entry_of(row["component"])
    fields = {field["name"]: field for field in entry["fields"]}
    check(row["field"] in fields, "components.json has no such field")
    field = fields[row["field"]]
    check(field["type"] == row["type"], "its type is %s", field["type"])
    check(same(field["default"], value_of(row["default"])), "its default is %r", field["default"])
    levels = row["levels"].split() or entry["levels"]
    check(field.get("levels", entry["levels"]) == levels, "it is of levels %s",
          field.get("levels"))


def check_property_entry(row):
    entry = entry_of(row["component"])
    check(row["property"] in entry["properties"], "components.json has no such property")
    default = value_of(row["default"])
    if default == [] and row["note"]:
        default = ""
    given = entry["properties"][row["property"]]
    check(same(given, default) or row["default"] == "[]" and given == [], "its default is %r",
          given)
    made = make(row["component"])
    made.properties(**{row["property"]: 5})
    check(made.property_value(row["property"]) == 5, "properties() does not set it")


def check_preset_entry(row):
    made = make(row["component"])
    entry = entry_of(row["component"])
    if row["component"] in ("CompoundSensor", "Kinect"):
        return  # known once names are
    check(same(entry["presets"].get(row["property"]), value_of(row["value"])),
          "components.json has %r", entry["presets"].get(row["property"]))
    check(same(made.property_value(row["property"]), value_of(row["value"])),
          "the builder's class sets it to %r", made.property_value(row["property"]))


def check_service_entry(row):
    entry = entry_of(row["component"])
    services = {service["name"]: service for service in entry["services"]}
    check(row["service"] in services, "components.json has no such service")
    service = services[row["service"]]
    required, optional, _ = _parameters("(%s)" % row["parameters"])
    expected = [{"name": name} for name in required] + [
        {"name": name, "default": value} for name, value in optional.items()]
    check(service["parameters"] == expected, "its parameters are %s", service["parameters"])
    check(service["asynchronous"] == row["kind"].startswith("async"), "asynchronous: %s",
          service["asynchronous"])
    check(service["interruptible"] == row["kind"].endswith("interruptible"), "interruptible: %s",
          service["interruptible"])


def missing_rows(tables):
    """What components.json has and the tables have not: [text]."""
    def known(table, *columns):
        return {tuple(row[column] for column in columns) for row in tables[table]}

    rows = {"fields": known("fields.csv", "component", "field"),
            "properties": known("properties.csv", "component", "property"),
            "presets": known("presets.csv", "component", "property"),
            "services": known("services.csv", "component", "service"),
            "modifiers": known("modifiers.csv", "component", "modifier")}
    found = []
    for name, entry in data.COMPONENTS.items():
        if name == "DepthVideoCamera":  # no class of MORSE's lists: what a Kinect is made of
            continue
        if (name,) not in known("components.csv", "component"):
            found.append(name)
        for key, those in rows.items():
            names = [item["name"] if isinstance(item, dict) else item for item in entry[key]]
            found += ["%s of %s: %s" % (key, name, item) for item in names
                      if (name, item) not in those]
    return found


def check_modifier_entry(row):
    made = make(row["component"])
    settings = eval("dict(%s)" % row["parameters"])
    if "." in row["modifier"]:
        made.alter(classpath=row["modifier"], **settings)
    else:
        made.alter(row["modifier"], **settings)
    modifier = made.modifiers[-1]
    check(modifier["settings"] == settings, "its settings are %s", modifier["settings"])
    check(modifier["classpath"].startswith("morse.modifiers."), "its class is %s",
          modifier["classpath"])
    check(modifier["direction"] == ("OUT" if entry_of(row["component"])["kind"] == "sensor"
                                    else "IN"), "it is applied %s", modifier["direction"])
