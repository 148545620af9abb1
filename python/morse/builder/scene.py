"""The scene that a script has built, as the scenario that the simulator reads (docs/scenario.md)."""

import datetime
import json
import math
import os
import re

from morse.builder import bpymorse, data, own, places, shapes
from morse.builder.abstractcomponent import AbstractComponent, Configuration
from morse.builder.blenderobjects import Mesh
from morse.builder.environment import Environment, _stand_in
from morse.builder.morsebuilder import PassiveObject, Robot, Zone
from morse.core.morse_time import TimeStrategies

_MOST_NAME = 64  # letters of a robot's name, in the simulator
_FASTEST = 100.0  # m/s and rad/s: MORSE has no limits, the simulator's highest
_POINT = 0.01  # m: half of a side of what stands for a body that nothing touches
_AROUND = 5.0  # m of floor around a robot that stands beside it
# Where on the Earth the world lies: properties of the environment.
_GEODESY = ("longitude", "latitude", "altitude", "angle_against_north")
_SYNC_PORT = 6000  # of time_sync, where a script names none
# MORSE's modifiers by their modules: the simulator's type, and its settings, each with the property
# of the environment that is asked where alter() says nothing.
_MODIFIERS = {
    "ecef": ("ECEF", {}), "feet": ("feet", {}), "geocentric": ("geocentric", {}),
    "geodetic": ("geodetic", {}), "ned": ("NED", {}),
    "utm": ("UTM", {"x_offset": "UTMXOffset", "y_offset": "UTMYOffset", "z_offset": "UTMZOffset"}),
    "pose_noise": ("PoseNoise", {"pos_std": "pos_std", "rot_std": "rot_std", "_2D": "_2D"}),
    "imu_noise": ("IMUNoise", {"gyro_std": "gyro_std", "accel_std": "accel_std"}),
    "odometry_noise": ("OdometryNoise", {name: name for name in
                                         ("factor", "factor_sigma", "gyro_drift",
                                          "gyro_drift_sigma")}),
}
_MAGNETIC = ("IMU", "Magnetometer")  # components that feel the Earth's field
_SIDEWAYS = ("Destination", "MotionXYW")  # components that take their robot in any direction
# Components that push their robot, which for them is a body that forces move.
_BY_FORCES = ("Drag", "ExternalForce", "ForceTorque", "QuadrotorDynamicControl",
              "RotorcraftAttitude", "RotorcraftVelocity", "RotorcraftWaypoint", "SteerForce")
# Properties that the builder itself sets.
_OF_THE_BUILDER = {"classpath", "robot_tag", "component_tag", "abstraction_level"}
_STRATEGIES = {TimeStrategies.BestEffort: "best_effort",
               TimeStrategies.FixedSimulationStep: "fixed_simulation_step"}


class SceneError(Exception):
    """A scene that cannot be."""


def build():
    """{"scene": the scenario, "notes": what it has not, "description": all the script said}."""
    environment = Environment.current
    if environment is None:
        raise SceneError("the script makes no Environment; add env = Environment('empty')")
    if not environment.created:
        environment.create()
    robots = [item for item in AbstractComponent.components
              if isinstance(item, Robot) and item.parent is None]
    names = {}
    scene = {"robots": [_robot(robot, names) for robot in robots]}
    dynamic = any("dynamics" in robot.get("body", {}) for robot in scene["robots"])
    physics = environment.physics(dynamic)
    if dynamic:
        scene["physics"] = physics
    _check_compounds(scene["robots"])
    scene.update(_world(environment, scene["robots"]))
    props = [_prop(item) for item in AbstractComponent.components
             if isinstance(item, PassiveObject) and not item.is_canvas]
    props += [_primitive(item) for item in AbstractComponent.components
              if isinstance(item, Mesh) and not isinstance(item, Zone) and item.parent is None and
              type(item).__name__ in shapes.PRIMITIVES]
    if props:
        scene["props"] = props
        # It depends on a robot's height what of a table is in its way.
        solid = any(prop.get("physics", "STATIC") != "NO_COLLISION" for prop in props
                    if "shape" in prop or "scale" in prop)
        if solid and isinstance(scene["world"], dict):
            scene["world"]["terrain"] = True
    scene.update(_canvas())
    zones = [item for item in AbstractComponent.components if isinstance(item, Zone)]
    if zones:
        scene["zones"] = [{"type": zone.zone_type, "position": list(zone.location),
                           "half_size": [abs(half) for half in zone.size]} for zone in zones]
    geodesy = {name: environment.property_value(name) for name in _GEODESY
               if environment.property_value(name) is not None}
    if geodesy:
        scene["geodesy"] = {name: float(value) for name, value in geodesy.items()}
    if any(component["type"] in _MAGNETIC for robot in scene["robots"]
           for component in robot["components"]):
        scene["magnetic_field"] = _magnetic_field(environment)
    for item in AbstractComponent.components:
        if isinstance(item, Zone):
            continue
        elif isinstance(item, Mesh):
            continue
        elif (item.parent is None and not isinstance(item, (Robot, PassiveObject, Environment)) and
              item.property_value("Component_Tag")):
            places.note("%s is appended to no robot" % item.name, item.place)
    scene["camera"] = {"position": environment._camera_location,
                       "rotation": environment._camera_rotation}
    scene["time"] = {"frequency": environment.base_frequency(),
                     "strategy": _STRATEGIES[environment._strategy],
                     "factor": environment._time_scale}
    sockets = Configuration.stream_managers.get("socket", {})
    if sockets.get("time_sync"):
        scene["time"]["sync_port"] = int(sockets.get("sync_port", _SYNC_PORT))
    if environment._multinode is not None and environment._multinode["protocol"] == "socket":
        nodes = _nodes(environment, names)
        if nodes:
            scene["multinode"] = {"server": environment._multinode["server_address"],
                                  "port": int(environment._multinode["server_port"]),
                                  "nodes": nodes}
    return {"scene": scene, "notes": [note.to_json() for note in places.notes],
            "description": _description(environment)}


def _nodes(environment, names):
    """The robots of each node; {} where the distribution is none of all robots."""
    found = {name: simulated for simulated, name in names.items()}
    nodes, rest = {}, set(names)
    for node, robots in environment._multinode["distribution"].items():
        nodes[str(node)] = []
        for robot in robots:
            simulated = found.get(robot)
            if simulated not in rest:
                places.note("configure_multinode(): there is no robot %s, or two nodes have it: all "
                            "robots are on this node" % robot, environment.place)
                return {}
            rest.discard(simulated)
            nodes[str(node)].append(simulated)
    if rest:
        places.note("configure_multinode() gives no node the robots %s: all robots are on this node"
                    % ", ".join(sorted(rest)), environment.place)
        return {}
    return nodes


# Robots

def _identifier(name, used):
    """A name that the simulator takes: letters, digits and '_', no two alike."""
    word = re.sub(r"[^A-Za-z0-9_]", "_", name)[:_MOST_NAME - 4] or "robot"
    found, number = word, 1
    while found in used:
        found = "%s_%03d" % (word, number)
        number += 1
    used[found] = name
    return found


def _robot(robot, names):
    x, y, z = robot.location
    roll, pitch, yaw = robot.rotation_euler
    if not all(math.isfinite(value) for value in (x, y, z, yaw)):
        raise SceneError("%s, made in line %d, has no place: (%s, %s, %s)" %
                         (robot.name, robot.place[1], x, y, z))
    if (abs(roll) > 1e-6 or abs(pitch) > 1e-6) and not _by_forces(robot):
        places.note("%s stands upright: its roll and pitch are not simulated" % robot.name,
                    robot.place)
    yaw -= 2.0 * math.pi * round(yaw / (2.0 * math.pi))  # as sensors have it
    name = _identifier(robot.full_name or robot.name, names)
    entry = robot.body_entry()
    if entry is None and robot.model_path is None:
        places.note("%s has no model: a box of 0.5 m stands in for it" % robot.name, robot.place)
        entry = {"mass": 10.0, "size": [0.5, 0.5], "z": [0.0, 0.5], "rest": 0.0}
    result = {"name": name, "pose": {"x": x, "y": y, "yaw": yaw}}
    if robot.paint is not None:
        result["color"] = _hex(robot.paint)
    if entry is None:
        result["type"] = "Custom"
        result["body"] = _body_of_model(robot, z)
    elif entry.get("type"):
        result["type"] = entry["type"]
    else:
        result["type"] = "Custom"
        result["body"] = _body(robot, entry, z)
        result["body"].update(_look(robot))
    if "body" in result:
        if robot.property_value("NoGravity") or (entry and entry["rest"] is None) or (
                entry is None and robot._bpy_object.game.physics_type == "NO_COLLISION"):
            result["body"]["flies"] = True
        own = _own_shapes(robot)
        if own:
            result["body"]["shape"] = result["body"].get("shape", []) + own
    result["z"] = z
    given = _given_properties(robot)
    if given:
        result["properties"] = given
    components, used = [], set()
    _components(robot, name, _IDENTITY, "", components, used)
    result["components"] = components
    if "socket" in robot.services:
        result["services"] = True
        if robot.skills:
            result["skills"] = list(robot.skills)
    if "body" in result and any(one["type"] in _SIDEWAYS or
                                one.get("own", {}).get("kind") == "actuator"
                                for one in components):
        result["body"]["drive"] = "omni"
        result["body"]["max_side_speed"] = _FASTEST
    for modifier in robot.modifiers:
        places.note("a robot has no data to alter", modifier["place"])
    return result


def _body(robot, entry, z):
    long, wide = entry["size"]
    scale = list(robot.scale)
    long, wide = long * scale[0], wide * scale[1]
    if entry.get("round"):
        corners = [[0.5 * long * math.cos(k * math.pi / 8.0), 0.5 * wide * math.sin(k * math.pi / 8.0)]
                   for k in range(16)]
    else:
        corners = [[0.5 * long, -0.5 * wide], [0.5 * long, 0.5 * wide], [-0.5 * long, 0.5 * wide],
                   [-0.5 * long, -0.5 * wide]]
    footprint = corners
    if robot._bpy_object.game.physics_type == "NO_COLLISION":
        # Nothing touches it, as nearly as may be.
        footprint = [[_POINT, -_POINT], [_POINT, _POINT], [-_POINT, _POINT], [-_POINT, -_POINT]]
    # What stands on the ground comes to rest on it; what flies stays where it was put, and so does
    # at first what forces move.
    by_forces = _by_forces(robot)
    height = entry["rest"] if entry["rest"] is not None else max(0.0, z)
    if by_forces:
        height = max(height, z)
    hull = []
    if entry["z"] is not None and robot.ghost is None:
        bottom = max(0.0, height + entry["z"][0] * scale[2])
        top = height + entry["z"][1] * scale[2]
        if top > bottom:
            hull = [{"outline": corners, "bottom": bottom, "top": top}]
    if entry["rest"] is None and z < 0.0:
        places.note("%s is beneath the ground: it is put on it" % robot.name, robot.place)
    result = {"footprint": footprint, "hull": hull, "origin_height": height,
              "mass": robot.mass if robot.mass else entry["mass"], "drive": "diff",
              "max_speed": _FASTEST, "max_turn_rate": _FASTEST}
    if by_forces:
        result["dynamics"] = _dynamics(robot, entry)
    return result


def _simulated_types(parent):
    for component in parent.children:
        if component._bpy_object is not None:
            yield simulated_type(component)
            yield from _simulated_types(component)


def _by_forces(robot):
    """Do forces move it, or StabilizedQuadrotor in space? Else it goes as it is told."""
    types = set(_simulated_types(robot))
    entry = robot.body_entry() or {}
    if entry.get("type"):
        return False
    return (robot.asked_for_physics or "StabilizedQuadrotor" in types or
            not types.isdisjoint(_BY_FORCES) or
            ("MotionVWDiff" in types and bool(entry.get("dynamics", {}).get("wheels"))))


def _dynamics(robot, entry):
    """The constants of MORSE (specs: H.1), and what the script says itself."""
    result = dict(entry.get("dynamics", {}))
    free = (robot._bpy_object.game.physics_type in ("NO_COLLISION", "STATIC") or
            "StabilizedQuadrotor" in _simulated_types(robot))
    result["kind"] = "free" if free else "rigid"
    low, high = entry["z"] if entry["z"] is not None else (-_POINT, _POINT)
    # The origin comes to rest where the model's is.
    bottom = result.get("bottom", low if entry["rest"] is None else -entry["rest"])
    result["bottom"], result["top"] = bottom * robot.scale[2], high * robot.scale[2]
    if robot.friction is not None:
        result["friction"] = float(robot.friction)
    result["gravity"] = not robot.property_value("NoGravity")
    result["ground"] = bool(robot.property_value("GroundRobot"))
    result["roll"], result["pitch"] = robot.rotation_euler[0], robot.rotation_euler[1]
    result["turning_track"] = float(robot.property_value("FixTurningSpeed") or 0.0)
    return result


def _hex(paint):
    return "#%02x%02x%02x" % tuple(min(255, max(0, round(255 * part))) for part in paint)


def _look(robot):
    """How the robot is shown: its model where it is installed, else a shape of our own."""
    if robot.model_path is not None:
        model = {"file": robot.model_path, "scale": list(robot.scale)}
        if robot.paint is not None:
            model["color"] = _hex(robot.paint)
        return {"model": model}
    if list(robot.scale) != [1.0, 1.0, 1.0]:
        return {}
    shape = shapes.robot(robot.stem, None if robot.paint is None else _hex(robot.paint))
    return {"shape": shape} if shape else {}


def _body_of_model(robot, z):
    """The body that the simulator makes of the user's own model."""
    body = dict(_look(robot), max_speed=_FASTEST, max_turn_rate=_FASTEST, drive="diff")
    physics = robot._bpy_object.game.physics_type
    if not isinstance(physics, bpymorse.FromModel):
        body["model"]["physics"] = str(physics)
    if robot.mass:
        body["mass"] = robot.mass
    if physics == "NO_COLLISION" or robot.property_value("NoGravity"):
        body["origin_height"] = max(0.0, z)
    return body


def _own_shapes(robot):
    """Primitives that a script has put on the robot."""
    found = []
    for item in robot.children:
        if not isinstance(item, Mesh) or type(item).__name__ not in shapes.PRIMITIVES:
            continue
        vertices, triangles = shapes.scaled(shapes.PRIMITIVES[type(item).__name__](), item.scale)
        found.append(shapes.mesh(vertices, triangles, _hex(item.paint or (0.8, 0.8, 0.8)),
                                 item.location, item.rotation_euler))
    return found


# Components

def _check_compounds(robots):
    """Says which sensors of a CompoundSensor have no data, as they are not simulated."""
    known = {"%s.%s" % (robot["name"], component["name"])
             for robot in robots for component in robot["components"]}
    for robot in robots:
        for component in robot["components"]:
            if component["type"] != "CompoundSensor":
                continue
            named = component.get("properties", {}).get("sensors", "").split(",")
            missing = [name for name in named if name and name not in known]
            if missing:
                full = "%s.%s" % (robot["name"], component["name"])
                place = next((item.place for item in AbstractComponent.components
                              if item.full_name == full), None)
                places.note("%s: it has no data of %s" % (full, ", ".join(missing)), place)


_IDENTITY = ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0, 0.0, 0.0])


def _moved(frame, component):
    """The frame of a component within the one that it is mounted in: (rotation, place)."""
    turn, place = frame
    at = [sum(turn[i][k] * component.location[k] for k in range(3)) + place[i] for i in range(3)]
    return bpymorse.multiply(turn, bpymorse.rotation_matrix(component.rotation_euler)), at


def _components(parent, robot, frame, prefix, result, used):
    for component in parent.children:
        if component._bpy_object is None:
            continue
        own = _moved(frame, component)
        name = _last_name(component)
        full = prefix + name
        number = 1
        while full in used:
            full = "%s%s_%03d" % (prefix, name, number)
            number += 1
        used.add(full)
        if isinstance(component, Robot):
            places.note("a robot on a robot is not simulated: %s is left out" % component.name,
                        component.place)
            continue
        made = _component(component, robot, full, own)
        if made is not None:
            result.append(made)
        _components(component, robot, own, full + ".", result, used)


def _last_name(component):
    name = component.full_name or component.name
    if component.full_name is not None:
        name = name.rsplit(".", 1)[-1]
    return re.sub(r"[^A-Za-z0-9_]", "_", name)


def simulated_type(component):
    """The simulator's type of a component; None where it has none."""
    classpath = component.property_value("classpath") or ""
    entry = data.component_of_class(classpath)
    if entry is None:
        return data.SYROTEK_COMPONENTS.get(classpath.rsplit(".", 1)[-1].lower())
    own = data.component_of_type(type(component))
    return (own if own and own["classpath"] == classpath else entry)["simulated"]


def _component(component, robot, name, frame):
    full = "%s.%s" % (robot, name)
    label = type(component).__name__
    code = own.code_of(component, full)
    if code is not None:
        made = _own_component(component, full, name, frame, code)
        return _with_overlays(made, component, full)
    kind = simulated_type(component)
    if kind is None:
        if isinstance(component, Mesh):
            return None
        classpath = component.property_value("classpath")
        known = classpath and data.component_of_class(classpath)
        places.note("%s: the component %s is not simulated yet%s" %
                    (full, label, "" if known else ", as is no component of one's own"),
                    component.place)
        return None
    level = component.chosen_level
    entry = component.table_entry()
    levelled = kind in ("GPS", "Odometry")  # the simulator has all their levels
    if level is not None and entry is not None and level != entry["default_level"] and not levelled:
        places.note("%s: the level %s of %s is not simulated yet" % (full, level, label),
                    component.place)
        return None
    turn, place = frame
    result = {
        "name": name, "type": kind, "frequency": component.rate or 60.0, "position": place,
        "rotation": [angle + 0.0 for angle in bpymorse.euler_angles(turn)],
        "stream": any(stream["middleware"] == "socket" for stream in component.streams),
        "services": "socket" in component.services}
    if level is not None and levelled:
        result["level"] = level
    if kind in ("LaserScanner", "VelodyneRayCast"):
        result["laser"] = _laser(component)
    elif entry is not None:
        given = _given_properties(component, set(entry["properties"]))
        if given:
            result["properties"] = given
    if kind == "IMU" and any(Environment.current.property_value(needed) is None
                             for needed in ("longitude", "latitude", "altitude")):
        places.note("%s: it has no magnetic field, as the environment has no longitude, latitude "
                    "and altitude" % full, component.place)
    if kind == "Keyboard":
        result["services"] = True  # the view's keys come that way
    modifiers = [made for made in (_modifier(modifier, full) for modifier in component.modifiers)
                 if made is not None]
    if modifiers:
        result["modifiers"] = modifiers
    return _with_overlays(result, component, full)


def _with_overlays(result, component, full):
    overlays = own.overlays_of(component, full)
    if overlays:
        result["overlays"] = overlays
    return result


def _modifier(modifier, full):
    """What alter() has asked for, as the simulator has it; None where it has not."""
    parts = modifier["classpath"].split(".")
    if parts[:2] != ["morse", "modifiers"] or len(parts) < 3 or parts[2] not in _MODIFIERS:
        places.note("%s: the modifier %s is not simulated yet" %
                    (full, modifier["name"] or modifier["classpath"]), modifier["place"])
        return None
    kind, of_environment = _MODIFIERS[parts[2]]
    settings = {}
    for name, property_name in of_environment.items():
        value = modifier["settings"].get(name)
        if value is None:
            value = Environment.current.property_value(property_name)
        if value is not None:
            settings[name] = value
    for name, value in modifier["settings"].items():
        if name in _GEODESY and kind in ("ECEF", "geodetic", "geocentric"):
            settings[name] = value
        elif name not in settings:
            places.note("%s: the modifier %s has no setting %s" % (full, kind, name),
                        modifier["place"])
    return {"type": kind, "settings": settings}


def _magnetic_field(environment):
    """MORSE's model of the Earth's magnetic field, where it is installed, of today."""
    today = datetime.date.today()
    first = datetime.date(today.year, 1, 1)
    year = (datetime.date(today.year + 1, 1, 1) - first).days
    result = {"date": today.year + (today - first).days / year}
    for folder in (data.data_folders() +
                   list(filter(None, os.environ.get("MORSE_RESOURCE_PATH", "").split(":")))):
        path = os.path.join(folder, "WMM.COF")
        if os.path.isfile(path):
            result["file"] = path
            return result
    places.note("no WMM.COF is installed (Debian's morse-simulator-data has it): the Earth's "
                "magnetic field is that of a dipole", environment.place)
    return result


def _own_component(component, full, name, frame, code):
    """A component whose code is the user's."""
    turn, place = frame
    result = {
        "name": name, "type": code["code"].rsplit(".", 1)[-1], "frequency": component.rate or 60.0,
        "position": place, "rotation": [angle + 0.0 for angle in bpymorse.euler_angles(turn)],
        "stream": any(stream["middleware"] == "socket" for stream in component.streams),
        "services": "socket" in component.services, "own": code}
    if code["language"] == "c++":
        result["type"] = os.path.splitext(os.path.basename(code["code"]))[0]
    given = _given_properties(component, code["properties"] if code["language"] == "python" else None)
    if given:
        result["properties"] = given
    for modifier in component.modifiers:
        places.note("%s: modifiers do not alter components of one's own" % full, modifier["place"])
    return result


def _given_properties(item, names=None):
    """What a script has set, as JSON can say it; `names`: only these, MORSE's own of a component."""
    given = {}
    for name, value in sorted(bpymorse.get_properties(item._bpy_object).items()):
        if name.lower() in _OF_THE_BUILDER or (names is not None and name not in names):
            continue
        if isinstance(value, float) and math.isnan(value):
            continue
        if isinstance(value, (bool, int, float, str)):
            given[name] = "inf" if value == math.inf else value
    return given


def _laser(component):
    values = component.arc or component.settings()
    laser = {"range": float(values["laser_range"]),
             "scan_window_deg": float(values["scan_window"]),
             "resolution_deg": float(values["resolution"]),
             "visible_arc": bool(values["Visible_arc"]), "layers": int(values["layers"]),
             "layer_separation": float(values["layer_separation"]),
             "layer_offset": float(values["layer_offset"])}
    if laser["scan_window_deg"] == 270.0 and laser["resolution_deg"] == 0.39589:
        laser["samples"] = 682  # as SyRoTek's robots have it, where counting gives 683
    return laser


# The world

def _world(environment, robots):
    stand_in = _stand_in(environment.filename)
    result = {"environment": environment.environment_file or environment.filename}
    if stand_in == "syrotek":
        result["world"] = "syrotek"
        return result
    if environment.environment_file is not None:
        # The user's own, or one of MORSE's: read by the simulator.
        result["world"] = {"file": environment.environment_file, "terrain": True}
        return result
    if stand_in in (None, "", "file"):
        places.note("the environment %s is not installed (Debian's morse-simulator-data has it): "
                    "an empty ground stands in for it" % environment.filename, environment.place)
        stand_in = "morse_empty"
    elif stand_in == "morse_sandbox":
        places.note("the sandbox is a stand-in of our own", environment.place, matters=False)
    with open(os.path.join(data.worlds_folder(), stand_in, "models", "arena.json"),
              encoding="utf-8") as file:
        world = json.load(file)
    _clear(world, robots, environment)
    _widen(world, robots)
    result["world"] = world
    return result


def _reach(robot):
    corners = robot.get("body", {}).get("footprint", [[0.2, 0.2]])
    return max(math.hypot(*corner) for corner in corners)


def _clear(world, robots, environment):
    """Takes away the stand-in's boxes that robots have been put on: MORSE's own may be elsewhere."""
    def is_free(box):
        half = 0.5 * math.hypot(*box["size"])
        return all(math.hypot(robot["pose"]["x"] - box["x"], robot["pose"]["y"] - box["y"]) >
                   half + _reach(robot) for robot in robots)

    if world["name"] != "morse_sandbox":
        return
    def is_clear(mesh):
        if not mesh.get("solid", True):
            return True
        half = max(math.hypot(x, y) for x, y, _ in mesh["vertices"])
        return is_free({"x": mesh["position"][0], "y": mesh["position"][1],
                        "size": [2.0 * half, 0.0]})

    free = [box for box in world["boxes"] if is_free(box)]
    clear = [mesh for mesh in world.get("meshes", []) if is_clear(mesh)]
    gone = len(world["boxes"]) - len(free) + len(world.get("meshes", [])) - len(clear)
    if gone:
        places.note("%d things of the sandbox are left out: robots stand there" % gone,
                    environment.place)
    world["boxes"], world["meshes"] = free, clear


def _widen(world, robots):
    """Lays floor beneath robots that stand beside it."""
    low, size = world["low"], world["size"]
    high = [low[0] + size[0], low[1] + size[1]]
    for robot in robots:
        around = _reach(robot)
        for axis, place in enumerate((robot["pose"]["x"], robot["pose"]["y"])):
            if place - around < low[axis]:
                low[axis] = place - around - _AROUND
            if place + around > high[axis]:
                high[axis] = place + around + _AROUND
    world["size"] = [high[0] - low[0], high[1] - low[1]]


def _prop(item):
    prop = {"name": item.name, "file": item.path or item._model, "object": item.prefix or "",
            "position": list(item.location), "rotation": list(item.rotation_euler),
            "properties": _given_properties(item)}
    if item.path is None:
        return prop  # its model is not installed, as has been said
    prop["scale"] = list(item.scale)
    if item.keep_pose:
        prop["keep_pose"] = True
    physics = item._bpy_object.game.physics_type
    if not isinstance(physics, bpymorse.FromModel):
        prop["physics"] = str(physics)
    return prop


def _primitive(item):
    """A shape: seen in views, and by nothing else unless a script gives it other physics."""
    vertices, triangles = shapes.scaled(shapes.PRIMITIVES[type(item).__name__](), item.scale)
    return {"name": item.name, "file": "",
            "shape": [shapes.mesh(vertices, triangles, _hex(item.paint or (0.8, 0.8, 0.8)))],
            "physics": str(item._bpy_object.game.physics_type),
            "position": list(item.location), "rotation": list(item.rotation_euler),
            "properties": _given_properties(item)}


def _canvas():
    """The canvas is always there; a script's own says how transparent it is (thesis 4.2.1)."""
    if not any(isinstance(item, PassiveObject) and item.is_canvas
               for item in AbstractComponent.components):
        return {}
    material = bpymorse.get_material("CanvasMat")
    alpha = material.alpha if material.use_transparency else 1.0
    return {"canvas": {"alpha": min(1.0, max(0.0, float(alpha)))}}


# All of it

def _plain(value):
    """What JSON can say of a value."""
    if isinstance(value, (bool, int, str)) or value is None:
        return value
    if isinstance(value, float):
        return value if math.isfinite(value) else str(value)
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple, set, bpymorse.Vector)):
        return [_plain(item) for item in value]
    return str(value)


def _described(item):
    game = item._bpy_object.game
    result = {
        "name": item.full_name or item.name, "class": type(item).__name__,
        "file": item.place[0], "line": item.place[1], "location": list(item.location),
        "rotation": list(item.rotation_euler), "scale": list(item.scale),
        "properties": bpymorse.get_properties(item._bpy_object), "frequency": item.rate,
        "level": item.chosen_level, "streams": item.streams, "services": item.services,
        "modifiers": item.modifiers, "color": item.paint,
        "overlays": [{key: value for key, value in overlay.items() if key != "place"}
                     for overlay in item.overlays],
        "physics": {"type": game.physics_type, "mass": game.mass}}
    if isinstance(item, Robot):
        result["friction"] = item.friction
        result["default_interfaces"] = item.default_interfaces
        result["ghost"] = item.ghost
        result["external"] = item.external
    if isinstance(item, PassiveObject):
        result["model"], result["prefix"] = item.path or item._model, item.prefix
        result["keep_pose"], result["graspable"] = item.keep_pose, item.graspable
    if item.children:
        result["children"] = [_described(child) for child in item.children
                              if child._bpy_object is not None]
    return result


def _description(environment):
    """Everything that the script has said, for tools and for what is not simulated yet."""
    objects = [_described(item) for item in AbstractComponent.components
               if item.parent is None and not isinstance(item, Environment)]
    return _plain({"environment": environment.description(), "objects": objects})
