"""Shapes of our own, as meshes of the scenario: Blender's primitives, and robots whose models are not
installed. x points forward, y left, z up; m."""

import math

_DARK, _RUBBER, _STEEL, _GLASS = "#2b2f36", "#1d1f22", "#b4bac2", "#3a4a5c"


def mesh(vertices, triangles, color="#cccccc", position=(0.0, 0.0, 0.0), rotation=(0.0, 0.0, 0.0)):
    """A mesh as scenarios have it."""
    return {"vertices": [[_short(value) for value in vertex] for vertex in vertices],
            "triangles": [list(triangle) for triangle in triangles], "color": color,
            "position": list(position), "rotation": list(rotation)}


def _short(value):
    return round(value, 6) + 0.0


def _lathe(profile, sides):
    """A body about z: `profile` has (radius, z) from the bottom up; a radius of 0 is a point."""
    vertices, rings = [], []
    for radius, z in profile:
        if radius == 0.0:
            rings.append([len(vertices)])
            vertices.append((0.0, 0.0, z))
            continue
        rings.append(list(range(len(vertices), len(vertices) + sides)))
        for k in range(sides):
            angle = 2.0 * math.pi * k / sides
            vertices.append((radius * math.cos(angle), radius * math.sin(angle), z))
    triangles = []
    for low, high in zip(rings, rings[1:]):
        for k in range(sides):
            a, b = low[k % len(low)], low[(k + 1) % len(low)]
            d, c = high[k % len(high)], high[(k + 1) % len(high)]
            if a != b:
                triangles.append((a, b, c))
            if c != d:
                triangles.append((a, c, d))
    return vertices, triangles


def cube(half=(1.0, 1.0, 1.0)):
    x, y, z = half
    vertices = [(sx * x, sy * y, sz * z) for sz in (-1, 1) for sy in (-1, 1) for sx in (-1, 1)]
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6))
    return vertices, [t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))]


def plane():
    return [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [(0, 1, 2), (0, 2, 3)]


def cylinder(radius=1.0, bottom=-1.0, top=1.0, sides=32):
    return _lathe([(0.0, bottom), (radius, bottom), (radius, top), (0.0, top)], sides)


def cone():
    return _lathe([(0.0, -1.0), (1.0, -1.0), (0.0, 1.0)], 32)


def sphere(radius=1.0, sides=24, rings=12):
    profile = [(radius * math.sin(math.pi * k / rings), -radius * math.cos(math.pi * k / rings))
               for k in range(rings + 1)]
    profile[0], profile[-1] = (0.0, -radius), (0.0, radius)
    return _lathe(profile, sides)


def torus(large=1.0, small=0.25, sides=32, rings=12):
    vertices = []
    for k in range(sides):
        around = 2.0 * math.pi * k / sides
        for j in range(rings):
            angle = 2.0 * math.pi * j / rings
            out = large + small * math.cos(angle)
            vertices.append((out * math.cos(around), out * math.sin(around),
                             small * math.sin(angle)))
    triangles = []
    for k in range(sides):
        for j in range(rings):
            a, b = k * rings + j, (k + 1) % sides * rings + j
            c, d = (k + 1) % sides * rings + (j + 1) % rings, k * rings + (j + 1) % rings
            triangles += [(a, b, c), (a, c, d)]
    return vertices, triangles


# As Blender adds them, before they are scaled.
PRIMITIVES = {"Plane": plane, "Cube": cube, "Sphere": sphere, "IcoSphere": sphere,
              "Cylinder": cylinder, "Cone": cone, "Torus": torus}


def scaled(shape, scale):
    """The shape, larger by a factor along each axis; a factor of 0 leaves next to nothing."""
    vertices, triangles = shape
    factors = [value if value != 0.0 else 1e-6 for value in scale]
    if factors[0] * factors[1] * factors[2] < 0.0:
        triangles = [(a, c, b) for a, b, c in triangles]
    return [tuple(v * f for v, f in zip(vertex, factors)) for vertex in vertices], triangles


# Robots

def _box(low, high, color):
    half = [0.5 * (h - l) for l, h in zip(low, high)]
    return mesh(*cube(half), color=color, position=[0.5 * (l + h) for l, h in zip(low, high)])


def _drum(radius, bottom, top, color, at=(0.0, 0.0)):
    return mesh(*cylinder(radius, bottom, top), color=color, position=(at[0], at[1], 0.0))


def _ball(radius, at, color):
    return mesh(*sphere(radius), color=color, position=at)


def _wheel(at, radius, width, rim=0.55):
    lying = (math.pi / 2.0, 0.0, 0.0)  # its axle along y
    half = 0.5 * width
    return [mesh(*cylinder(radius, -half, half), color=_RUBBER, position=at, rotation=lying),
            mesh(*cylinder(rim * radius, -half - 0.004, half + 0.004), color=_STEEL, position=at,
                 rotation=lying)]


def _atrv(paint):
    parts = [_box((-0.57, -0.29, 0.14), (0.57, 0.29, 0.42), paint),
             _box((-0.5, -0.24, 0.42), (0.46, 0.24, 0.56), paint),
             _box((-0.46, -0.2, 0.56), (0.2, 0.2, 0.6), _DARK),
             _box((0.57 - 0.04, -0.22, 0.2), (0.573, 0.22, 0.34), _DARK),
             _drum(0.012, 0.6, 0.737, _DARK, (-0.4, 0.16)),
             _box((0.2, -0.18, 0.56), (0.44, 0.18, 0.64), _GLASS)]
    for x in (0.31, -0.31):
        for y in (0.335 - 0.07, -0.335 + 0.07):
            parts += _wheel((x, y, 0.1), 0.2, 0.14)
    return parts


def _morsy(paint):
    white = "#f2f2ee"
    parts = [_drum(0.36, 0.014, 0.12, _DARK), _drum(0.3, 0.12, 0.5, paint),
             _ball(0.36, (0.0, 0.0, 0.72), paint), _drum(0.1, 1.02, 1.14, _STEEL),
             _box((-0.24, -0.34, 1.12), (0.24, 0.34, 1.52), paint),
             _box((0.24, -0.28, 1.18), (0.26, 0.28, 1.46), _GLASS),
             _drum(0.012, 1.52, 1.66, _STEEL), _ball(0.036, (0.0, 0.0, 1.66), "#e0b020")]
    for y in (0.14, -0.14):
        parts.append(_ball(0.085, (0.25, y, 1.33), white))
        parts.append(_ball(0.04, (0.325, y, 1.33), _DARK))
    for side in (1.0, -1.0):
        parts.append(_ball(0.1, (0.0, 0.44 * side, 0.92), _STEEL))
        parts.append(_box((-0.06, 0.44 * side - 0.07, 0.5), (0.06, 0.44 * side + 0.07, 0.9), paint))
        parts.append(_ball(0.09, (0.02, 0.44 * side, 0.46), white))
    return parts


def _pioneer(paint):
    parts = [_box((-0.2, -0.135, -0.045), (0.19, 0.135, 0.055), paint),
             _box((-0.225, -0.18, 0.055), (0.225, 0.18, 0.07), _DARK),
             _box((0.19, -0.1, -0.02), (0.205, 0.1, 0.04), _DARK),
             _box((-0.12, -0.12, 0.07), (0.1, 0.12, 0.09), _DARK),
             _ball(0.0385, (-0.17, 0.0, -0.0615), _RUBBER)]
    for y in (0.157, -0.157):
        parts += _wheel((0.045, y, -0.0025), 0.0975, 0.05)
    return parts


def _segway(paint):
    parts = [_box((-0.5, -0.21, 0.06), (0.5, 0.21, 0.25), _DARK),
             _box((-0.42, -0.19, 0.25), (0.42, 0.19, 0.29), paint),
             _box((-0.36, -0.015, 0.29), (-0.33, 0.015, 0.355), _STEEL),
             _box((0.33, -0.015, 0.29), (0.36, 0.015, 0.355), _STEEL)]
    for x in (0.27, -0.27):
        for y in (0.312, -0.312):
            parts += _wheel((x, y, 0.1), 0.25, 0.168)
    return parts


def _rotors(radius, arm, height, paint):
    parts = [_box((-0.08, -0.08, height - 0.05), (0.08, 0.08, height + 0.03), paint),
             _box((-arm, -0.012, height - 0.012), (arm, 0.012, height + 0.012), _DARK),
             _box((-0.012, -arm, height - 0.012), (0.012, arm, height + 0.012), _DARK),
             _box((arm - 0.05, -0.02, height - 0.005), (arm + 0.01, 0.02, height + 0.02), "#d04030")]
    for x, y in ((arm, 0.0), (0.0, arm), (-arm, 0.0), (0.0, -arm)):
        parts.append(_drum(0.02, height, height + 0.028, _STEEL, (x, y)))
        parts.append(_drum(radius, height + 0.028, height + 0.034, "#8f99a6", (x, y)))
    return parts


def _quadrotor(paint):
    parts = _rotors(0.115, 0.235, 0.0, paint)
    for x, y in ((0.12, 0.12), (0.12, -0.12), (-0.12, 0.12), (-0.12, -0.12)):
        parts.append(_box((x - 0.006, y - 0.006, -0.161), (x + 0.006, y + 0.006, -0.01), _DARK))
    return parts


def _quad2012(paint):
    return _rotors(0.1, 0.2, 0.03, paint) + [
        _box((-0.1, -0.008, -0.1), (0.1, 0.008, -0.09), _DARK),
        _box((-0.008, -0.008, -0.1), (0.008, 0.008, 0.0), _DARK)]


def _b21(paint):
    return [_drum(0.255, 0.03, 0.4, paint), _drum(0.262, 0.4, 0.42, _DARK),
            _drum(0.255, 0.42, 0.9, paint), _drum(0.2, 0.9, 0.94, _DARK),
            _drum(0.267, 0.06, 0.12, _DARK), _drum(0.1, 0.0, 0.05, _RUBBER)]


def _patrolbot(paint):
    parts = [_drum(0.22, -0.11, 0.13, paint), _box((-0.05, -0.2, -0.11), (0.25, 0.2, 0.1), paint),
             _box((0.25, -0.12, -0.06), (0.262, 0.12, 0.04), _DARK),
             _drum(0.17, 0.13, 0.174, _DARK), _ball(0.05, (-0.19, 0.0, -0.124), _RUBBER)]
    for y in (0.2, -0.2):
        parts += _wheel((0.0, y, -0.083), 0.091, 0.04)
    return parts


def _person(paint):
    skin = "#d8a888"
    parts = [_drum(0.09, 0.0, 0.82, "#2f3f63", (0.0, 0.1)), _drum(0.09, 0.0, 0.82, "#2f3f63", (0.0, -0.1)),
             _box((-0.1, -0.2, 0.8), (0.1, 0.2, 1.42), paint), _drum(0.05, 1.42, 1.5, skin),
             _ball(0.12, (0.0, 0.0, 1.56), skin), _ball(0.03, (0.115, 0.0, 1.55), skin)]
    for side in (1.0, -1.0):
        parts.append(_drum(0.045, 0.82, 1.4, paint, (0.0, 0.24 * side)))
        parts.append(_ball(0.05, (0.0, 0.24 * side, 0.79), skin))
    return parts


# By the models' names: what makes them, and the colour where a script gives none.
_ROBOTS = {"atrv": (_atrv, "#b3261e"), "morsy": (_morsy, "#2864b4"), "pioneer3dx": (_pioneer, "#a3201a"),
           "segwayrmp400": (_segway, "#d8dade"), "quadrotor_dynamic": (_quadrotor, "#2f6f4f"),
           "quadrotor": (_quad2012, "#39424e"), "b21": (_b21, "#7d1f2a"),
           "patrolbot": (_patrolbot, "#c33325"), "human_rig": (_person, "#3c7a5a"),
           "victim": (_person, "#b07040")}


def robot(stem, paint=None):
    """Meshes of a stand-in for the robot's model, in its frame; none where there is none."""
    if stem not in _ROBOTS:
        return []
    make, color = _ROBOTS[stem]
    return make(paint or color)
