"""The vectors and rotations that components of one's own need, where Blender's are not there."""

import math


class Vector(list):
    """Numbers with + - * /, x, y, z and a length."""

    def _of(self, values):
        return Vector(values)

    def __add__(self, other):
        return self._of(a + b for a, b in zip(self, other))

    def __sub__(self, other):
        return self._of(a - b for a, b in zip(self, other))

    def __mul__(self, factor):
        return self._of(a * factor for a in self)

    __rmul__ = __mul__

    def __truediv__(self, divisor):
        return self._of(a / divisor for a in self)

    def __neg__(self):
        return self._of(-a for a in self)

    def _at(index):  # pylint: disable=no-self-argument
        def get(self):
            return self[index]

        def put(self, value):
            self[index] = value
        return property(get, put)

    x, y, z, w = _at(0), _at(1), _at(2), _at(3)

    @property
    def length(self):
        return math.sqrt(self.dot(self))

    magnitude = length

    def dot(self, other):
        return sum(a * b for a, b in zip(self, other))

    def cross(self, other):
        (a, b, c), (d, e, f) = self, other
        return self._of((b * f - c * e, c * d - a * f, a * e - b * d))

    def normalized(self):
        length = self.length
        return self / length if length > 0.0 else self._of(self)

    def copy(self):
        return self._of(self)


class Euler(Vector):
    """Roll, pitch and yaw as x, y and z, rad, in the order XYZ."""

    def _of(self, values):
        return Euler(values)

    def to_matrix(self):
        return Matrix.from_euler(*self)


class Quaternion:
    """w, x, y, z."""

    def __init__(self, wxyz=(1.0, 0.0, 0.0, 0.0)):
        self.w, self.x, self.y, self.z = wxyz


class Matrix(list):
    """Rows of numbers; @ multiplies by a vector or a matrix."""

    def __init__(self, rows):
        super().__init__([list(row) for row in rows])

    @staticmethod
    def identity():
        return Matrix([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])

    @staticmethod
    def from_euler(roll, pitch, yaw):
        """Rz(yaw) Ry(pitch) Rx(roll)"""
        (sr, cr), (sp, cp), (sy, cy) = ((math.sin(a), math.cos(a)) for a in (roll, pitch, yaw))
        return Matrix([[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                       [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                       [-sp, cp * sr, cp * cr]])

    def to_euler(self):
        pitch = math.asin(max(-1.0, min(1.0, -self[2][0])))
        if abs(self[2][0]) > 1.0 - 1e-12:  # looking straight up or down: all of it is roll
            return Euler((math.atan2(-self[1][2], self[1][1]), pitch, 0.0))
        return Euler((math.atan2(self[2][1], self[2][2]), pitch,
                      math.atan2(self[1][0], self[0][0])))

    def transposed(self):
        return Matrix(zip(*self))

    def __matmul__(self, other):
        if other and isinstance(other[0], (list, tuple)):
            columns = list(zip(*other))
            return Matrix([[sum(a * b for a, b in zip(row, column)) for column in columns]
                           for row in self])
        return Vector(sum(a * b for a, b in zip(row, other)) for row in self)

    __mul__ = __matmul__
