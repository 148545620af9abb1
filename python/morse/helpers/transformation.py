"""Where something is in space: MORSE's Transformation3d."""

import math

from morse.core.mathutils import Euler, Matrix, Vector


class Transformation3d:
    """A place (m) and a rotation (rad), in the world unless somebody says otherwise."""

    def __init__(self, obj=None):
        self._at = Vector((0.0, 0.0, 0.0))
        self._turn = Matrix.identity()
        if obj is not None:
            self.update(obj)

    @classmethod
    def of(cls, place, angles):
        """From x, y, z and roll, pitch, yaw."""
        made = cls()
        made._at = Vector(place)
        made._turn = Matrix.from_euler(*angles)
        return made

    def update(self, obj):
        """Takes the pose of an object that has a position_3d or is one."""
        other = getattr(obj, "position_3d", obj)
        self._at, self._turn = Vector(other._at), Matrix(other._turn)

    x = property(lambda self: self._at[0])
    y = property(lambda self: self._at[1])
    z = property(lambda self: self._at[2])
    roll = property(lambda self: self._turn.to_euler().x)
    pitch = property(lambda self: self._turn.to_euler().y)
    yaw = property(lambda self: self._turn.to_euler().z)
    translation = property(lambda self: Vector(self._at))
    rotation_matrix = property(lambda self: Matrix(self._turn))

    @property
    def euler(self):
        return Euler((self.roll, self.pitch, self.yaw))

    @property
    def matrix(self):
        """4 x 4."""
        rows = [list(row) + [at] for row, at in zip(self._turn, self._at)]
        return Matrix(rows + [[0.0, 0.0, 0.0, 1.0]])

    def times(self, other):
        """`other`, which is given in this frame, in the frame that this one is given in."""
        made = Transformation3d()
        made._at = self._at + self._turn @ other._at
        made._turn = self._turn @ other._turn
        return made

    def transformation3d_with(self, other):
        """Where `other` is as seen from here."""
        back = self._turn.transposed()
        made = Transformation3d()
        made._at = back @ (other._at - self._at)
        made._turn = back @ other._turn
        return made

    def distance(self, other):
        """m"""
        return math.dist(self._at, other._at)

    def distance_2d(self, other):
        """m, in the plane"""
        return math.dist(self._at[:2], other._at[:2])

    def __repr__(self):
        return "x %.6g y %.6g z %.6g yaw %.6g pitch %.6g roll %.6g" % (
            self.x, self.y, self.z, self.yaw, self.pitch, self.roll)
