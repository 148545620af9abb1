"""The world around the robots, and how it is simulated: MORSE's Environment."""

import logging
import os
import sys

from morse.builder import bpymorse, data, places
from morse.builder.abstractcomponent import AbstractComponent, Configuration
from morse.builder.morsebuilder import Component, Robot
from morse.core.morse_time import TimeStrategies

logger = logging.getLogger("morsebuilder")


def _looks(text):
    # How Blender's window looks: nothing that a run depends on.
    places.note("%s has no effect" % text, matters=False)


class Environment(AbstractComponent):
    """Made after the robots, to which it gives their names and default interfaces."""

    is_environment = True
    current = None  # the one made last
    multinode_distribution = {}

    def __init__(self, filename, main_scene=None, fastmode=False, component_renaming=True,
                 auto_tune_time=True):
        super().__init__(bpymorse.Object("Scene_Script_Holder", "EMPTY"), filename, "environments")
        self.filename = filename
        self.fastmode = fastmode
        self.environment_file = self._find(filename)
        self._component_renaming = component_renaming
        self._auto_tune_time = auto_tune_time
        self._base_frequency = 60.0
        self._frequency_chosen = False
        self._strategy = TimeStrategies.BestEffort
        self._time_scale = 1.0
        self._camera_location = [5, -5, 5]
        self._camera_rotation = [0.7854, 0, 0.7854]
        self._camera = {}
        self._gravity = 9.81
        self._physics_step_sub = 2
        self._gravity_place = self._step_sub_place = None
        self._relative_time = False
        self._internal_syncer = False
        self._multinode = None
        self._log_levels = {}
        self._display_camera = None
        self.created = False
        self.properties(environment_file=filename)
        if fastmode:
            logger.warning("Running in fastmode! No camera support!")
        frame = sys._getframe(1)
        while frame.f_back is not None and frame.f_code.co_name == "__init__":
            frame = frame.f_back
        AbstractComponent.name_by_variables(frame.f_locals)
        if component_renaming:
            self._rename_components()
        self._handle_default_interface()
        Environment.current = self

    @staticmethod
    def _find(filename):
        path = data.find_asset("environments", filename) if filename else None
        if path is None and _stand_in(filename) is None:
            raise data.asset_missing("environments", filename)
        return path

    # Names and interfaces

    @staticmethod
    def _rename_components():
        used = set()

        def rename(component, prefix):
            if component.basename is not None:
                full = prefix + component.basename
                if full in used:
                    number = 1
                    while "%s_%03d" % (full, number) in used:
                        number += 1
                    new = "%s_%03d" % (full, number)
                    if isinstance(component, Robot):
                        places.note("two robots are called %s; this one is %s" % (full, new),
                                    component.place)
                    full = new
                used.add(full)
                component.full_name = full
                component._bpy_object.name = full
            for child in component.children:
                rename(child, component.name + ".")

        for component in list(AbstractComponent.components):
            if component.parent is None and isinstance(component, Robot):
                rename(component, "")
        for component in list(AbstractComponent.components):
            component.after_renaming()

    def _handle_default_interface(self):
        for robot in AbstractComponent.components:
            if isinstance(robot, Robot):
                for interface in robot.default_interfaces:
                    for child in robot.children:
                        self._configure_default_interface(child, interface)

    def _configure_default_interface(self, component, interface):
        if component.is_exportable():
            if not any(stream["middleware"] == interface for stream in component.streams):
                component.add_stream(interface)
            if interface in data.SERVICE_MIDDLEWARES:
                component.add_service(interface)
        for child in component.children:
            self._configure_default_interface(child, interface)

    def create(self, name=None):
        """Finishes the scene. Called by itself at the end of a script that does not."""
        if name:
            self.name = name
        if not self._component_renaming or not self.created:
            for component in AbstractComponent.components:
                if not component.full_name:
                    component.after_renaming()
        self.created = True

    # Time

    def set_time_strategy(self, strategy):
        """TimeStrategies.BestEffort or FixedSimulationStep."""
        if strategy not in (TimeStrategies.BestEffort, TimeStrategies.FixedSimulationStep):
            raise ValueError("no time strategy: %r" % (strategy,))
        self._strategy = strategy
        if strategy == TimeStrategies.FixedSimulationStep:
            self._auto_tune_time = False

    def set_time_scale(self, slowdown_by=None, accelerate_by=None):
        """How much slower or faster than real time."""
        if slowdown_by and accelerate_by:
            raise ValueError("either slowdown_by or accelerate_by")
        self._time_scale = 1.0 / slowdown_by if slowdown_by else float(accelerate_by or 1.0)

    def simulator_frequency(self, base_frequency=60, logic_step_max=20, physics_step_max=20):
        """Ticks a simulated second, Hz."""
        self._base_frequency = float(base_frequency)
        self._auto_tune_time = False
        bpymorse.set_speed(base_frequency, logic_step_max, physics_step_max)

    def use_internal_syncer(self):
        self._internal_syncer = True
        self._auto_tune_time = False
        places.note("use_internal_syncer() is not needed: the pace is kept without", matters=False)

    def use_relative_time(self, relative_time):
        """Counts the time from 0, as it always does here."""
        self._relative_time = relative_time

    def use_vsync(self, vsync):
        _looks("use_vsync()")

    def set_physics_step_sub(self, step_sub):
        self._physics_step_sub = step_sub
        self._step_sub_place = places.user_place()

    def physics(self, matters):
        """What the scene says of physics; they matter where forces move a robot."""
        if not matters:
            if self._gravity != 9.81:
                places.note("set_gravity() has no effect: robots stay on the ground",
                            self._gravity_place)
            if self._physics_step_sub != 2:
                places.note("set_physics_step_sub() has no effect: robots move exactly",
                            self._step_sub_place)
        return {"gravity": self._gravity, "substeps": max(1, min(20, int(self._physics_step_sub)))}

    def frequency(self, frequency=None):
        """Ticks a simulated second, Hz: the same as simulator_frequency()."""
        if frequency is not None:
            self.simulator_frequency(frequency)

    def base_frequency(self):
        """Ticks a simulated second: as many as the fastest component asks for."""
        if not self._auto_tune_time:
            return self._base_frequency
        rates = [component.rate for component in AbstractComponent.components if component.rate]
        return max([self._base_frequency] + rates)

    # View

    def set_camera_location(self, location):
        self._camera_location = list(location)

    def set_camera_rotation(self, rotation):
        self._camera_rotation = list(rotation)

    place_camera = set_camera_location
    aim_camera = set_camera_rotation

    def set_camera_clip(self, clip_start=0.1, clip_end=100):
        self._camera["clip"] = [clip_start, clip_end]

    def set_camera_speed(self, speed=2.0):
        self._camera["speed"] = speed

    def set_camera_focal_length(self, focal_length=20.0):
        self._camera["focal_length"] = focal_length

    def set_horizon_color(self, color=(0.05, 0.22, 0.4)):
        _looks("set_horizon_color()")

    def enable_mist(self, value=True):
        _looks("enable_mist()")

    def set_mist_settings(self, **settings):
        _looks("set_mist_settings()")

    def show_debug_properties(self, value=True):
        _looks("show_debug_properties()")

    def show_framerate(self, value=True):
        _looks("show_framerate()")

    def show_physics(self, value=True):
        _looks("show_physics()")

    def set_material_mode(self, material_mode="GLSL"):
        if material_mode not in ("GLSL", "MULTITEXTURE", "SINGLETEXTURE"):
            logger.warning("no material mode is called %s", material_mode)
        _looks("set_material_mode()")

    def set_viewport(self, viewport_shade="WIREFRAME", clip_end=1000):
        _looks("set_viewport()")

    def set_auto_start(self, auto_start=True):
        _looks("set_auto_start()")

    def fullscreen(self, fullscreen=True):
        _looks("fullscreen()")

    def set_stereo(self, mode="ANAGLYPH", eye_separation=0.1, stereo="STEREO"):
        _looks("set_stereo()")

    def set_animation_record(self, record=True):
        _looks("set_animation_record()")

    def set_background_scene(self, scene):
        _looks("set_background_scene()")

    def select_display_camera(self, robot_camera):
        """Shows what this camera sees."""
        if not isinstance(robot_camera, AbstractComponent):
            logger.warning("select_display_camera() takes a camera")
            return
        self._display_camera = robot_camera
        _looks("select_display_camera()")

    def is_internal_camera(self, camera):
        """Is it Blender's own?"""
        return camera.name in ("Camera", "CameraFP", "CameraCompositing")

    # The rest

    def set_gravity(self, gravity=9.81):
        """m/s^2, downwards; only a float counts, as in MORSE."""
        if isinstance(gravity, float):
            self._gravity = gravity
            self._gravity_place = places.user_place()

    def set_debug(self, debug=True):
        logging.getLogger().setLevel(logging.DEBUG if debug else logging.INFO)

    def set_log_level(self, component, level):
        """Of the logger of a component or of a middleware."""
        self._log_levels[component] = level

    def configure_multinode(self, protocol="socket", server_address="localhost",
                            server_port="65000", distribution=None):
        """Several simulators for one scene."""
        self._multinode = {"protocol": protocol, "server_address": server_address,
                           "server_port": str(server_port), "distribution": distribution or {}}
        if protocol != "socket":
            places.note("multinode over %s is not simulated, 'socket' is: all robots are on this "
                        "node" % protocol)

    def configure_stream_manager(self, stream_manager, **kwargs):
        """Settings of a middleware, for example time_sync=True of 'socket'."""
        Configuration.stream_managers.setdefault(stream_manager, {}).update(kwargs)

    def add_service(self, interface, component=None, config=None):
        """Serves `simulation` and the like over this middleware, too."""
        if interface not in Configuration.simulation_services:
            Configuration.simulation_services.append(interface)
            places.note("services over %s are not simulated, 'socket' is" % interface)

    def configure_service(self, datastream):
        self.add_service(datastream)

    def add_stream(self, datastream, method=None, path=None, classpath=None, direction=None,
                   **kwargs):
        logger.error("an environment has no stream of %s", datastream)

    def add_interface(self, interface, **kwargs):
        self.add_service(interface)
        self.add_stream(interface)

    def save(self, filepath=None, check_existing=False, compress=True):
        places.note("save() is not simulated: there is no file of Blender's to save; "
                    "`ccmorse convert` writes the scene as JSON")

    def description(self):
        """All that the script has said of it, as JSON."""
        return {
            "filename": self.filename, "file": self.environment_file, "fastmode": self.fastmode,
            "properties": bpymorse.get_properties(self._bpy_object),
            "camera": dict(self._camera, location=self._camera_location,
                           rotation=self._camera_rotation,
                           display=str(self._display_camera) if self._display_camera else None),
            "time": {"strategy": self._strategy, "scale": self._time_scale,
                     "frequency": self.base_frequency(), "relative": self._relative_time,
                     "internal_syncer": self._internal_syncer},
            "gravity": self._gravity, "physics_step_sub": self._physics_step_sub,
            "multinode": self._multinode, "log_levels": self._log_levels,
            "stream_managers": Configuration.stream_managers,
            "services": Configuration.simulation_services}


def _stand_in(filename):
    """The name of the world that stands in for an environment; "file" for those of MORSE that are
    read, "" for its others, None for
    what is none of its."""
    if not filename:
        return None
    name = filename[:-len(".blend")] if filename.endswith(".blend") else filename
    if name in data.ENVIRONMENTS:
        return data.ENVIRONMENTS[name] or ""
    for folder in data.data_folders():
        start = os.path.join(folder, "environments") + os.sep
        if name.startswith(start) and name[len(start):] in data.ENVIRONMENTS:
            return data.ENVIRONMENTS[name[len(start):]] or ""
    if os.path.basename(name) == "arena":
        return data.ENVIRONMENTS["arena"]
    return None


__all__ = ["AbstractComponent", "Component", "Environment", "bpymorse", "logging", "os", "sys"]
