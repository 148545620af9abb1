"""A stand-in for Blender's data, as far as builder scripts reach into it (docs/morse.md).

Objects have a name, a place, game settings, materials and properties that can be read and set;
nothing is drawn. What a script sets here and the simulation has no use for stays without effect.
"""

import math
import re


class Vector:
    """Numbers with names, which can be set one by one: a location, a scale, Euler angles."""

    def __init__(self, values=(0.0, 0.0, 0.0)):
        self._values = [float(value) for value in values]

    def __len__(self):
        return len(self._values)

    def __iter__(self):
        return iter(self._values)

    def __getitem__(self, index):
        return self._values[index]

    def __setitem__(self, index, value):
        if isinstance(index, slice):
            changed = list(self._values)
            changed[index] = [float(item) for item in value]
            if len(changed) != len(self._values):
                raise ValueError("a vector keeps its length of %d" % len(self._values))
            self._values = changed
        else:
            self._values[index] = float(value)

    def __repr__(self):
        return "Vector((%s))" % ", ".join("%.4f" % value for value in self._values)

    def __eq__(self, other):
        return list(self) == list(other)

    __hash__ = None

    def __add__(self, other):
        return Vector([a + b for a, b in zip(self, other)])

    def __sub__(self, other):
        return Vector([a - b for a, b in zip(self, other)])

    def __mul__(self, factor):
        return Vector([a * factor for a in self])

    __rmul__ = __mul__

    def __neg__(self):
        return self * -1.0

    @property
    def length(self):
        return math.sqrt(sum(value * value for value in self))

    def copy(self):
        return Vector(self)

    def _named(index):  # pylint: disable=no-self-argument
        return property(lambda self: self[index],
                        lambda self, value: self.__setitem__(index, value))

    x = _named(0)
    y = _named(1)
    z = _named(2)
    r = _named(0)
    g = _named(1)
    b = _named(2)
    del _named


def rotation_matrix(euler):
    """Rows of Rz(z) Ry(y) Rx(x): Euler angles XYZ as Blender has them, rad."""
    cx, cy, cz = (math.cos(angle) for angle in euler)
    sx, sy, sz = (math.sin(angle) for angle in euler)
    return [[cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
            [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
            [-sy, cy * sx, cy * cx]]


def euler_angles(matrix):
    """Euler angles XYZ, rad, of a rotation's rows."""
    level = math.hypot(matrix[0][0], matrix[1][0])
    pitch = math.atan2(-matrix[2][0], level)
    if level < 1e-9:  # straight up or down: all of the turn is given to x
        return [math.atan2(-matrix[1][2], matrix[1][1]), pitch, 0.0]
    return [math.atan2(matrix[2][1], matrix[2][2]), pitch,
            math.atan2(matrix[1][0], matrix[0][0])]


def multiply(a, b):
    """The product of two matrices, as rows."""
    return [[sum(a[i][k] * b[k][j] for k in range(len(b))) for j in range(len(b[0]))]
            for i in range(len(a))]


class GameProperty:
    """A property of a game object: its type is BOOL, INT, FLOAT, STRING or TIMER."""

    def __init__(self, name, value, kind):
        self.name = name
        self.value = value
        self.type = kind


class Named(list):
    """A list that also finds its items by their names."""

    def __getitem__(self, key):
        if isinstance(key, str):
            for item in self:
                if item.name == key:
                    return item
            raise KeyError(key)
        return list.__getitem__(self, key)

    def __contains__(self, key):
        if isinstance(key, str):
            return any(item.name == key for item in self)
        return list.__contains__(self, key)

    def get(self, key, default=None):
        return self[key] if key in self else default

    def keys(self):
        return [item.name for item in self]


class Settings:
    """Whatever Blender has that nothing here depends on: can be set and read."""

    def __init__(self, **known):
        self.__dict__.update(known)

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        # As an unset switch of Blender is.
        return False


class FromModel(str):
    """What a model file says of an object, as long as no script says something else."""


class Game(Settings):
    """Physics and properties of an object."""

    def __init__(self):
        super().__init__(
            physics_type="NO_COLLISION", mass=1.0, radius=1.0, use_actor=False, use_ghost=False,
            use_collision_bounds=False, collision_bounds_type="BOX", use_collision_compound=False,
            lock_location_x=False, lock_location_y=False, lock_location_z=False,
            lock_rotation_x=False, lock_rotation_y=False, lock_rotation_z=False, damping=0.04,
            rotation_damping=0.1, collision_margin=0.04, form_factor=0.4, use_sleep=False,
            properties=Named(), sensors=Named(), controllers=Named(), actuators=Named())


class Material(Settings):
    """A material: a colour, and how transparent it is."""

    def __init__(self, name):
        super().__init__(name=name, diffuse_color=Vector((0.8, 0.8, 0.8)), alpha=1.0,
                         use_transparency=False, transparency_method="Z_TRANSPARENCY",
                         specular_intensity=0.5, emit=0.0,
                         physics=Settings(friction=0.5, elasticity=0.0))


class Object(Settings):
    """An object of the scene."""

    def __init__(self, name, kind="MESH"):
        super().__init__(_name=_unique(name), _parent=None, type=kind, children=[],
                         game=Game(), material_slots=Named(), data=Settings(name=name),
                         scale=Vector((1.0, 1.0, 1.0)), dimensions=Vector(), select=False,
                         hide=False, hide_render=False)
        self.__dict__["location"] = Vector()
        self.__dict__["rotation_euler"] = Vector()
        _objects.append(self)

    def __setattr__(self, name, value):
        if name in ("location", "rotation_euler", "scale", "dimensions"):
            value = Vector(value)
        if name == "name":
            value = value if value == self.name else _unique(value)
            name = "_name"
        if name == "parent":
            if self._parent is not None:
                self._parent.children.remove(self)
            if value is not None:
                value.children.append(self)
            name = "_parent"
        self.__dict__[name] = value

    def __getattr__(self, name):
        if name == "name":
            return self.__dict__["_name"]
        if name == "parent":
            return self.__dict__["_parent"]
        return Settings.__getattr__(self, name)

    @property
    def active_material(self):
        return self.material_slots[0].material if self.material_slots else None

    @property
    def matrix_local(self):
        turn = rotation_matrix(self.rotation_euler)
        rows = [[turn[i][k] * self.scale[k] for k in range(3)] + [self.location[i]]
                for i in range(3)]
        return rows + [[0.0, 0.0, 0.0, 1.0]]

    matrix_basis = matrix_local

    @property
    def matrix_world(self):
        local = self.matrix_local
        return local if self.parent is None else multiply(self.parent.matrix_world, local)

    matrix_parent_inverse = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0],
                             [0.0, 0.0, 0.0, 1.0]]


_objects = Named()
_materials = Named()
_texts = Named()
_sounds = Named()
_lamps = Named()
_scenes = Named([Settings(name="S.MORSE_LOGIC", game_settings=Settings(),
                          render=Settings(fps=60), world=Settings())])


def _unique(name):
    # As Blender does it: the second "Cube" is "Cube.001".
    if name not in _objects:
        return name
    stem = re.sub(r"\.\d{3,}$", "", name)
    number = 1
    while "%s.%03d" % (stem, number) in _objects:
        number += 1
    return "%s.%03d" % (stem, number)


def reset():
    """Forgets everything: for tests."""
    for known in (_objects, _materials, _texts, _sounds, _lamps):
        del known[:]


def _look_up(known, name_or_id):
    if isinstance(name_or_id, int):
        return known[name_or_id] if -len(known) <= name_or_id < len(known) else None
    return known.get(name_or_id)


def version():
    """The version of Blender that MORSE 1.4 was last made for."""
    return (2, 79, 0)


def get_objects():
    return _objects


def get_object(name_or_id):
    return _look_up(_objects, name_or_id)


def get_materials():
    return _materials


def get_material(name_or_id):
    return _look_up(_materials, name_or_id)


def get_last_material():
    return _materials[-1] if _materials else None


def create_new_material(name="Material"):
    """Adds a material; returns it."""
    material = Material(name)
    _materials.append(material)
    return material


def get_lamps():
    return _lamps


def get_lamp(name_or_id):
    return _look_up(_lamps, name_or_id)


def get_last_lamp():
    return _lamps[-1] if _lamps else None


def get_texts():
    return _texts


def get_text(name_or_id):
    return _look_up(_texts, name_or_id)


def get_last_text():
    return _texts[-1] if _texts else None


def get_sounds():
    return _sounds


def get_sound(name_or_id):
    return _look_up(_sounds, name_or_id)


def get_last_sound():
    return _sounds[-1] if _sounds else None


def get_scenes():
    return _scenes


def get_scene(name_or_id):
    return _look_up(_scenes, name_or_id)


def get_last_scene():
    return _scenes[-1]


def set_active_scene(name_or_id):
    """There is one scene only, which is active."""
    return get_scene(name_or_id)


def get_context_scene():
    return _scenes[0]


def get_context_window():
    return Settings()


def get_context_object():
    selected = get_selected_objects()
    return selected[-1] if selected else None


def get_selected_objects():
    return [item for item in _objects if item.select]


def get_first_selected_object():
    selected = get_selected_objects()
    return selected[0] if selected else None


def deselect_all():
    for item in _objects:
        item.select = False


def select_only(obj):
    deselect_all()
    obj.select = True


def add_morse_empty(shape="ARROWS"):
    """Adds an object without a body; returns it."""
    return Object("Empty", "EMPTY")


def delete(objects):
    """Takes an object or several, also by name, out of the scene."""
    for item in objects if isinstance(objects, (list, tuple)) else [objects]:
        item = get_object(item) if isinstance(item, str) else item
        if item in _objects:
            item.parent = None
            _objects.remove(item)


def get_fps():
    return _scenes[0].render.fps


def set_speed(fps=60, logic_step_max=20, physics_step_max=20):
    _scenes[0].render.fps = fps


def get_properties(obj):
    """Name -> value of an object's game properties."""
    return {item.name: item.value for item in obj.game.properties}


def properties(obj, **kwargs):
    """Sets game properties of an object, with the type that the value has in Python."""
    for name, value in kwargs.items():
        kind = _kind_of(value)
        if kind is None:
            value, kind = str(value), "STRING"
        if name in obj.game.properties:
            known = obj.game.properties[name]
            known.value, known.type = value, kind
        else:
            obj.game.properties.append(GameProperty(name, value, kind))


def _kind_of(value):
    if getattr(value, "is_morse_timer", False):
        return "TIMER"
    for kind, name in ((bool, "BOOL"), (int, "INT"), (float, "FLOAT"), (str, "STRING")):
        if isinstance(value, kind):
            return name
    return None


def _without_effect(*args, **kwargs):
    """Does in Blender what needs Blender."""


set_debug = save = set_viewport = set_viewport_perspective = fullscreen = _without_effect
