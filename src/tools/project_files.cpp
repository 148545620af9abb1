#include "tools/project_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ccmorse::tools {
namespace {

bool IsLetter(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_';
}

bool IsDigit(char letter) { return letter >= '0' && letter <= '9'; }

constexpr std::array<std::string_view, 35> kPythonWords = {
    "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};

// Packages that src/NAME, which comes first in sys.path, would stand before: MORSE's own and those
// of Python that builder, components and clients need.
constexpr std::array<std::string_view, 40> kTakenModules = {
    "abc",      "argparse", "array",     "ast",      "base64",  "collections", "copy",
    "datetime", "enum",     "functools", "inspect",  "io",      "itertools",   "json",
    "logging",  "math",     "mathutils", "morse",    "numbers", "operator",    "os",
    "pathlib",  "pickle",   "pymorse",   "queue",    "random",  "re",          "select",
    "signal",   "socket",   "string",    "struct",   "sys",     "tempfile",    "threading",
    "time",     "types",    "typing",    "unittest", "warnings"};

template <std::size_t N>
bool Has(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string Replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
    text.replace(at, what.size(), by);
  }
  return text;
}

// @NAME@, @CLASS@, ... of a template.
struct Words {
  std::string name;
  std::string class_name;
  std::string package;
  std::string description;
};

std::string Filled(std::string text, const Words& words) {
  text = Replaced(std::move(text), "@NAME@", words.name);
  text = Replaced(std::move(text), "@CLASS@", words.class_name);
  text = Replaced(std::move(text), "@PACKAGE@", words.package);
  return Replaced(std::move(text), "@DESCRIPTION@", words.description);
}

// A description as it may stand in docstrings and strings of Python, and in comments of C++.
std::string Plain(const std::string& description) {
  std::string plain;
  for (const char letter : description) {
    const bool printable = static_cast<unsigned char>(letter) >= 0x20;
    plain += letter == '"' ? '\'' : letter == '\\' ? '/' : printable ? letter : ' ';
  }
  return plain;
}

constexpr const char* kDefaultScript = R"py(#! /usr/bin/env morseexec
"""What `morse run @NAME@` starts: one robot in a playground.

Change anything and run it again. New parts of your own come by
`morse add robot|sensor|actuator NAME @NAME@`.
"""

from morse.builder import *

# The robot: 1 m along x from the middle of the world, turned left by 3.5 rad.
robot = Morsy()
robot.translate(1.0, 0.0, 0.0)
robot.rotate(0.0, 0.0, 3.5)

# It moves by linear (m/s) and angular (rad/s) speed ...
motion = MotionVW()
robot.append(motion)

# ... and by the arrow keys.
keyboard = Keyboard()
robot.append(keyboard)
keyboard.properties(ControlType='Position')

# It reports where it is.
pose = Pose()
robot.append(pose)

# Programs reach all of this through sockets; scripts/@NAME@_client.py is one.
robot.add_default_interface('socket')

env = Environment('sandbox', fastmode=False)
env.set_camera_location([-18.0, -6.7, 10.8])
env.set_camera_rotation([1.09, 0, -1.14])
)py";

constexpr const char* kClient = R"py(#! /usr/bin/env python3
"""Drives the robot of @NAME@ on a curve for five seconds and prints where it is.

Start the simulation first: morse run @NAME@
Needs pymorse (Debian's package python3-morse-simulator).
"""

import time

from pymorse import Morse

simulation = Morse()
try:
    robot = simulation.robot
    robot.motion.publish({'v': 0.3, 'w': 0.5})
    for _ in range(5):
        time.sleep(1.0)
        pose = robot.pose.get()
        print('x %.3f m, y %.3f m, yaw %.3f rad' % (pose['x'], pose['y'], pose['yaw']))
    robot.motion.publish({'v': 0.0, 'w': 0.0})
    robot.pose.get()  # by then the robot has its last command
finally:
    # pymorse's own way to wait for what is unsent fails with Python 3.8 and newer.
    simulation.close(wait_publishers=False)
)py";

constexpr const char* kBuilderPackage =
    "# Builder classes of this environment: `morse add` puts them into robots, sensors and "
    "actuators.\n";

constexpr const char* kSensor = R"py("""@DESCRIPTION@"""

import math

import morse.core.sensor
from morse.core import status
from morse.core.services import async_service, interruptible, service
from morse.helpers.components import add_data, add_property


class @CLASS@(morse.core.sensor.Sensor):
    """@DESCRIPTION@

    As it is, it measures how far it has travelled. It runs inside the simulation; scripts mount it
    by the class of the same name in @PACKAGE@.builder.sensors.
    """
    _name = "@CLASS@"
    _short_desc = "@DESCRIPTION@"

    # Each line sent to clients has these fields, beside `timestamp`.
    add_data('distance', 0.0, 'float', 'way travelled since the start or the last reset, in metres')

    # Scripts set these: @NAME@.properties(Factor=2.0)
    add_property('_factor', 1.0, 'Factor', 'float', 'what the distance is multiplied by')

    def __init__(self, obj, parent=None):
        morse.core.sensor.Sensor.__init__(self, obj, parent)
        self._last = None
        self._goal = 0.0

    @service
    def reset_distance(self):
        """Counts from 0 again."""
        self.local_data['distance'] = 0.0

    @interruptible
    @async_service
    def travel(self, metres):
        """Answers when so much more has been travelled; another call takes this one's place."""
        self._goal = self.local_data['distance'] + metres

    def default_action(self):
        """What happens each time that the sensor is due."""
        here = (self.position_3d.x, self.position_3d.y, self.position_3d.z)
        if self._last is not None:
            way = math.sqrt(sum((a - b) ** 2 for a, b in zip(here, self._last)))
            self.local_data['distance'] += self._factor * way
        self._last = here
        if self.local_data['distance'] >= self._goal:
            self.completed(status.SUCCESS, self.local_data['distance'])
)py";

constexpr const char* kSensorBuilder = R"py("""The sensor @CLASS@ for builder scripts."""

from morse.builder.creator import SensorCreator


class @CLASS@(SensorCreator):
    """@DESCRIPTION@

        from @PACKAGE@.builder.sensors import @CLASS@
        @NAME@ = @CLASS@()
        robot.append(@NAME@)
    """
    _classpath = "@PACKAGE@.sensors.@NAME@.@CLASS@"

    def __init__(self, name=None):
        SensorCreator.__init__(self, name)
)py";

constexpr const char* kActuator = R"py("""@DESCRIPTION@"""

import morse.core.actuator
from morse.core import status
from morse.core.services import async_service, interruptible, service
from morse.helpers.components import add_data, add_property


class @CLASS@(morse.core.actuator.Actuator):
    """@DESCRIPTION@

    As it is, it moves its robot ahead. It runs inside the simulation; scripts mount it by the class
    of the same name in @PACKAGE@.builder.actuators.
    """
    _name = "@CLASS@"
    _short_desc = "@DESCRIPTION@"

    # Clients send lines with these fields; the last one holds until the next.
    add_data('speed', 0.0, 'float', 'of the robot along its own x axis, in metres per second')

    # Scripts set these: @NAME@.properties(MaxSpeed=0.5)
    add_property('_max_speed', 1.0, 'MaxSpeed', 'float', 'no command makes it faster, m/s')

    def __init__(self, obj, parent=None):
        morse.core.actuator.Actuator.__init__(self, obj, parent)
        self._left = 0.0

    @service
    def stop(self):
        """Stands still until the next command."""
        self.local_data['speed'] = 0.0

    @interruptible
    @async_service
    def advance(self, metres, speed=0.5):
        """Answers when the robot has gone so far."""
        self._left = metres
        self.local_data['speed'] = speed

    def interrupt(self):
        """Another call, or a cancel, ends a running `advance`."""
        self._left = 0.0
        self.local_data['speed'] = 0.0
        morse.core.actuator.Actuator.interrupt(self)

    def default_action(self):
        """What happens each time that the actuator is due."""
        speed = max(-self._max_speed, min(self._max_speed, self.local_data['speed']))
        self.apply_speed('Velocity', [speed, 0.0, 0.0], [0.0, 0.0, 0.0])
        if self._left > 0.0:
            self._left -= abs(speed) / self.frequency
            if self._left <= 0.0:
                self.stop()
                self.completed(status.SUCCESS)
)py";

constexpr const char* kActuatorBuilder = R"py("""The actuator @CLASS@ for builder scripts."""

from morse.builder.creator import ActuatorCreator


class @CLASS@(ActuatorCreator):
    """@DESCRIPTION@

        from @PACKAGE@.builder.actuators import @CLASS@
        @NAME@ = @CLASS@()
        robot.append(@NAME@)
    """
    _classpath = "@PACKAGE@.actuators.@NAME@.@CLASS@"

    def __init__(self, name=None):
        ActuatorCreator.__init__(self, name)
)py";

constexpr const char* kSensorPlugin =
    R"plugin(// @DESCRIPTION@
//
// Built by `make` in this folder; builder scripts mount it by the class @CLASS@ of
// @PACKAGE@.builder.sensors. How to write one: docs/components.md of CCMorse.

#include <ccmorse/plugin.h>

#include <cmath>

// As it is, it measures how far it has travelled.
class @CLASS@ : public ccmorse::Sensor {
 public:
  @CLASS@() {
    // Each line sent to clients has these fields, beside `timestamp`.
    AddData("distance", 0.0);  // m, travelled since the start or the last reset

    // Scripts set these: @NAME@.properties(Factor=2.0)
    AddProperty("Factor", &factor_);

    // Clients call these; the second text names their parameters, as "x y ?speed".
    AddService("reset_distance", "", [this](const ccmorse::Values&) {
      Set("distance", 0.0);
      return ccmorse::Value();
    });

    // This one answers when so much more has been travelled.
    AddAsyncService("travel", "metres", [this](const ccmorse::Values& arguments) {
      goal_ = Get("distance").Number() + arguments[0].Number();
    });
  }

  // What happens each time that the sensor is due.
  void DefaultAction() override {
    const ccmorse::Pose here = GetPose();
    if (moving_) {
      const double way = std::hypot(here.x - last_.x, here.y - last_.y, here.z - last_.z);
      Set("distance", Get("distance").Number() + factor_ * way);
    }
    last_ = here;
    moving_ = true;
    if (Get("distance").Number() >= goal_) Complete(ccmorse::Status::kSuccess, Get("distance"));
  }

 private:
  double factor_ = 1.0;  // what the distance is multiplied by
  double goal_ = 0.0;    // m
  bool moving_ = false;  // last_ is known
  ccmorse::Pose last_{};
};

CCMORSE_PLUGIN(@CLASS@)
)plugin";

constexpr const char* kActuatorPlugin =
    R"plugin(// @DESCRIPTION@
//
// Built by `make` in this folder; builder scripts mount it by the class @CLASS@ of
// @PACKAGE@.builder.actuators. How to write one: docs/components.md of CCMorse.

#include <ccmorse/plugin.h>

#include <algorithm>
#include <cmath>

// As it is, it moves its robot ahead.
class @CLASS@ : public ccmorse::Actuator {
 public:
  @CLASS@() {
    // Clients send lines with these fields; the last one holds until the next.
    AddData("speed", 0.0);  // m/s, of the robot along its own x axis

    // Scripts set these: @NAME@.properties(MaxSpeed=0.5)
    AddProperty("MaxSpeed", &max_speed_);

    // Clients call these; the second text names their parameters, as "x y ?speed".
    AddService("stop", "", [this](const ccmorse::Values&) {
      Set("speed", 0.0);
      return ccmorse::Value();
    });

    // This one answers when the robot has gone so far.
    AddAsyncService("advance", "metres speed", [this](const ccmorse::Values& arguments) {
      left_ = arguments[0].Number();
      Set("speed", arguments[1].Number());
    });
  }

  // What happens each time that the actuator is due.
  void DefaultAction() override {
    const double speed = std::clamp(Get("speed").Number(), -max_speed_, max_speed_);
    ApplySpeed(speed, 0.0, 0.0);
    const double step = GetTime() - last_time_;
    last_time_ = GetTime();
    if (left_ <= 0.0) return;
    left_ -= std::abs(speed) * step;
    if (left_ <= 0.0) Stop(ccmorse::Status::kSuccess);
  }

  // Another call, or `cancel`, ends a running `advance`.
  void Interrupt() override { Stop(ccmorse::Status::kPreempted); }

 private:
  void Stop(ccmorse::Status status) {
    left_ = 0.0;
    Set("speed", 0.0);
    Complete(status);
  }

  double max_speed_ = 1.0;  // m/s: no command makes it faster
  double left_ = 0.0;       // m to go
  double last_time_ = 0.0;  // s
};

CCMORSE_PLUGIN(@CLASS@)
)plugin";

constexpr const char* kPluginMakefile =
    R"mk(# Builds each .cpp of this folder as a plug-in of CCMorse.
CXX ?= g++
CXXFLAGS ?= -O2 -Wall -Wextra
CCMORSE_FLAGS ?= $(or $(shell pkg-config --cflags ccmorse 2>/dev/null),-I@INCLUDE@)

all: $(patsubst %.cpp,%.so,$(wildcard *.cpp))

%.so: %.cpp Makefile
	$(CXX) -std=c++17 $(CXXFLAGS) $(CCMORSE_FLAGS) -fPIC -shared -fvisibility=hidden -o $@ $<

clean:
	rm -f *.so

.PHONY: all clean
)mk";

constexpr const char* kPluginBuilder = R"py("""The @KIND@ @CLASS@ for builder scripts."""

import os

from morse.builder.creator import @CREATOR@


class @CLASS@(@CREATOR@):
    """@DESCRIPTION@

        from @PACKAGE@.builder.@KIND@s import @CLASS@
        @NAME@ = @CLASS@()
        robot.append(@NAME@)
    """
    _plugin = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                           "..", "..", "plugins", "@NAME@.so")

    def __init__(self, name=None):
        @CREATOR@.__init__(self, name)
)py";

constexpr const char* kRobot = R"py("""@DESCRIPTION@"""

import morse.core.robot


class @CLASS@(morse.core.robot.Robot):
    """@DESCRIPTION@

    It runs inside the simulation; scripts place it by the class of the same name in
    @PACKAGE@.builder.robots.
    """
    _name = "@CLASS@"

    def __init__(self, obj, parent=None):
        morse.core.robot.Robot.__init__(self, obj, parent)

    def default_action(self):
        """Each tick: nothing, as actuators move the robot."""
)py";

constexpr const char* kRobotBuilder = R"py("""The robot @CLASS@ for builder scripts."""

from morse.builder import *


class @CLASS@(GroundRobot):
    """@DESCRIPTION@

        from @PACKAGE@.builder.robots import @CLASS@
        robot = @CLASS@()

    Its shape is data/@PACKAGE@/robots/@NAME@.obj. With debug the arrow keys drive it.
    """

    def __init__(self, name=None, debug=True):
        GroundRobot.__init__(self, '@PACKAGE@/robots/@NAME@.obj', name)
        self.properties(classpath="@PACKAGE@.robots.@NAME@.@CLASS@")

        # What every robot of this kind carries.
        self.motion = MotionVW()
        self.append(self.motion)

        self.pose = Pose()
        self.append(self.pose)

        if debug:
            keyboard = Keyboard()
            keyboard.properties(ControlType='Position')
            self.append(keyboard)
)py";

// A box of 0.4 x 0.3 x 0.2 m on the floor, x ahead, z up.
constexpr const char* kRobotShape =
    R"obj(# The shape of the robot @NAME@: metres, x ahead, y left, z up, (0, 0, 0) on the floor.
# Replace it by any model of your own.
o @NAME@
v -0.2 -0.15 0.0
v 0.2 -0.15 0.0
v 0.2 0.15 0.0
v -0.2 0.15 0.0
v -0.2 -0.15 0.2
v 0.2 -0.15 0.2
v 0.2 0.15 0.2
v -0.2 0.15 0.2
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)obj";

// A ball as an icosahedron, whose corners are those of three golden rectangles; x, y, radius in m.
std::string Ball(int id, double x, double y, double radius, const char* color) {
  const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
  const double a = radius / std::sqrt(1.0 + golden * golden);
  const double b = a * golden;
  return fmt::format(
      R"(      {{"id": {0}, "name": "ball", "color": "{1}", "position": [{2}, {3}, {4:.4f}],
       "vertices": [[-{5:.4f}, {6:.4f}, 0], [{5:.4f}, {6:.4f}, 0], [-{5:.4f}, -{6:.4f}, 0], [{5:.4f}, -{6:.4f}, 0],
                    [0, -{5:.4f}, {6:.4f}], [0, {5:.4f}, {6:.4f}], [0, -{5:.4f}, -{6:.4f}], [0, {5:.4f}, -{6:.4f}],
                    [{6:.4f}, 0, -{5:.4f}], [{6:.4f}, 0, {5:.4f}], [-{6:.4f}, 0, -{5:.4f}], [-{6:.4f}, 0, {5:.4f}]],
       "triangles": [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2],
                     [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5],
                     [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]]}})",
      id, color, x, y, radius, a, b);
}

// A seat that fills the way down to the floor, and its back.
std::string Chair(int id, double x, double y) {
  constexpr double kBackOffset = 0.13;
  return fmt::format(
      R"(      {{"id": {}, "kind": "seat", "x": {}, "y": {}, "size": [0.3, 0.3]}},
      {{"id": {}, "kind": "back", "x": {:.2f}, "y": {}, "size": [0.04, 0.3]}})",
      id, x, y, id + 1, x - kBackOffset, y);
}

std::string Playground() {
  std::string text = R"({
  "world": {
    "name": "playground", "size": [6, 6], "floor": "#c8c0a8",
    "kinds": {
      "border": {"height": 0.2, "color": "#7a4a1e"},
      "seat": {"height": 0.25, "color": "#3c6ebe"},
      "back": {"height": 0.55, "color": "#3c6ebe"},
      "block": {"height": 0.3, "color": "#d62828"}
    },
    "boxes": [
      {"id": 1, "kind": "border", "x": 3, "y": 0.05, "size": [6, 0.1]},
      {"id": 2, "kind": "border", "x": 3, "y": 5.95, "size": [6, 0.1]},
      {"id": 3, "kind": "border", "x": 0.05, "y": 3, "size": [0.1, 5.8]},
      {"id": 4, "kind": "border", "x": 5.95, "y": 3, "size": [0.1, 5.8]},
      {"id": 5, "kind": "block", "x": 4.6, "y": 1.2, "yaw_deg": 30, "size": [0.5, 0.5]},
)";
  text += Chair(10, 1.2, 1.5) + ",\n" + Chair(12, 1.2, 4.4) + ",\n" + Chair(14, 4.4, 4.6) + "\n";
  text += "    ],\n    \"meshes\": [\n";
  text += Ball(21, 2.1, 3.9, 0.25, "orange") + ",\n" + Ball(22, 3.4, 1.4, 0.15, "yellow") + ",\n" +
          Ball(23, 4.9, 3.2, 0.35, "green") + "\n";
  text += R"(    ]
  },
  "robots": [{"name": "robot", "pose": {"x": 4, "y": 3, "yaw": 3.5}}],
  "camera": {"position": [3, -3.2, 4.6], "rotation": [0.95, 0, 0]}
}
)";
  return text;
}

}  // namespace

std::string_view KindName(ComponentKind kind) {
  switch (kind) {
    case ComponentKind::kRobot:
      return "robot";
    case ComponentKind::kSensor:
      return "sensor";
    case ComponentKind::kActuator:
      break;
  }
  return "actuator";
}

std::string ProblemOfPythonName(std::string_view name) {
  if (name.empty()) return "is empty";
  for (const char letter : name) {
    if (IsLetter(letter) || IsDigit(letter)) continue;
    if (letter == ' ') return "has a blank";
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x20 || byte >= 0x7f) return "has something else than letters, digits and '_'";
    return fmt::format("has a '{}'", letter);
  }
  if (IsDigit(name.front())) return "begins with a digit";
  if (Has(kPythonWords, name)) return "is a word of Python";
  if (Has(kTakenModules, name)) return "is a module that Python or MORSE needs itself";
  return "";
}

std::string AsPythonName(std::string_view name) {
  std::string good;
  for (const char letter : name) {
    if (IsLetter(letter) || IsDigit(letter)) {
      good += letter;
    } else if (!good.empty() && good.back() != '_') {
      good += '_';
    }
  }
  while (!good.empty() && good.back() == '_') good.pop_back();
  if (good.empty()) return "";
  if (IsDigit(good.front())) good.insert(0, "env_");
  if (!ProblemOfPythonName(good).empty()) good.insert(0, "my_");
  return good;
}

std::string ClassName(std::string_view name) {
  std::string text(name);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (i == 0 && letter >= 'a' && letter <= 'z') text[i] = static_cast<char>(letter - 'a' + 'A');
    if (i > 0 && letter >= 'A' && letter <= 'Z') text[i] = static_cast<char>(letter - 'A' + 'a');
  }
  return text;
}

std::vector<ProjectFile> NewProject(const std::string& name, bool with_scenario) {
  const Words words{name, "", name, ""};
  std::vector<ProjectFile> files = {
      {"default.py", Filled(kDefaultScript, words), true},
      {"scripts/" + name + "_client.py", Filled(kClient, words), true},
      {"src/" + name + "/__init__.py", ""},
      {"src/" + name + "/builder/__init__.py", kBuilderPackage},
      // MORSE's folder for models; an empty folder would get lost on the way through a zip or git.
      {"data/" + name + "/README.md",
       "Models and maps of this environment. Builder scripts find them by their paths from "
       "data/.\n"},
  };
  if (with_scenario) files.push_back({"scenario.json", Playground()});
  return files;
}

std::vector<ProjectFile> NewComponent(ComponentKind kind, const std::string& name,
                                      const std::string& package, const std::string& description) {
  const Words words{name, ClassName(name), package, Plain(description)};
  const std::string folder = std::string(KindName(kind)) + "s";
  const std::string own = "src/" + package + "/" + folder + "/";
  const std::string builder = "src/" + package + "/builder/" + folder + "/";
  const char* const component = kind == ComponentKind::kRobot    ? kRobot
                                : kind == ComponentKind::kSensor ? kSensor
                                                                 : kActuator;
  const char* const creator = kind == ComponentKind::kRobot    ? kRobotBuilder
                              : kind == ComponentKind::kSensor ? kSensorBuilder
                                                               : kActuatorBuilder;
  std::vector<ProjectFile> files = {{own + name + ".py", Filled(component, words)},
                                    {builder + name + ".py", Filled(creator, words)}};
  if (kind == ComponentKind::kRobot) {
    files.push_back({"data/" + package + "/robots/" + name + ".obj", Filled(kRobotShape, words)});
  }
  return files;
}

std::vector<ProjectFile> NewPlugin(ComponentKind kind, const std::string& name,
                                   const std::string& package, const std::string& description,
                                   const std::string& include) {
  const Words words{name, ClassName(name), package, Plain(description)};
  const std::string kind_name(KindName(kind));
  const bool senses = kind == ComponentKind::kSensor;
  const std::string source = "src/" + package + "/plugins/";
  std::string builder = Filled(kPluginBuilder, words);
  builder = Replaced(std::move(builder), "@KIND@", kind_name);
  builder = Replaced(std::move(builder), "@CREATOR@", senses ? "SensorCreator" : "ActuatorCreator");
  return {{source + name + ".cpp", Filled(senses ? kSensorPlugin : kActuatorPlugin, words)},
          {source + "Makefile", Replaced(kPluginMakefile, "@INCLUDE@", include)},
          {"src/" + package + "/builder/" + kind_name + "s/" + name + ".py", std::move(builder)}};
}

std::string BuilderImport(const std::string& name) {
  return "from ." + name + " import " + ClassName(name) + "\n";
}

}  // namespace ccmorse::tools
