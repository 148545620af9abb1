"""Shapes: MORSE's primitives. Nothing runs into them and no scanner sees them, as in MORSE."""

from morse.builder import bpymorse
from morse.builder.abstractcomponent import AbstractComponent


class Mesh(AbstractComponent):
    """A shape by its name."""

    _half = (1.0, 1.0, 1.0)  # extents, m, before it is scaled

    def __init__(self, name=None):
        super().__init__()
        obj = bpymorse.Object(name or type(self).__name__)
        obj.dimensions = [2.0 * half for half in self._half]
        self.set_blender_object(obj)
        if name:
            self.name = name

    def color(self, r=0.1, g=0.1, b=0.1):
        self.set_color(r, g, b)


def _shape(name, half):
    return type(name, (Mesh,), {"_half": half, "__doc__": "A %s." % name, "__module__": __name__})


Plane = Cube = Sphere = IcoSphere = Cylinder = Cone = Torus = Empty = None
for _name, _size in (("Plane", (1, 1, 0)), ("Cube", (1, 1, 1)), ("Sphere", (1, 1, 1)),
                     ("IcoSphere", (1, 1, 1)), ("Cylinder", (1, 1, 1)), ("Cone", (1, 1, 1)),
                     ("Torus", (1.25, 1.25, 0.25)), ("Empty", (0, 0, 0))):
    globals()[_name] = _shape(_name, _size)


class Coordsys(AbstractComponent):
    """Three arrows."""

    def __init__(self, name=None):
        super().__init__(bpymorse.Object(name or "Coordsys", "EMPTY"))
        if name:
            self.name = name


class Spot(AbstractComponent):
    """A lamp."""

    def __init__(self, name=None, lamp_type="SPOT"):
        super().__init__(bpymorse.Object(name or "Spot", "LAMP"))
        if name:
            self.name = name
        self._bpy_object.data = bpymorse.Settings(
            name=self.name, type=lamp_type, energy=1.0, distance=25.0, spot_size=0.785,
            color=bpymorse.Vector((1.0, 1.0, 1.0)))


class Camera(AbstractComponent):
    """A camera of Blender's own."""

    def __init__(self, name=None):
        super().__init__(bpymorse.Object(name or "Camera", "CAMERA"))
        if name:
            self.name = name
        self._bpy_object.data = bpymorse.Settings(
            name=self.name, lens=35.0, clip_start=0.1, clip_end=100.0, angle=0.8575560,
            sensor_width=32.0)
