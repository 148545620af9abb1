"""MORSE's robots, with the sizes and masses of robots.json."""

from morse.builder import data
from morse.builder.morsebuilder import GroundRobot, Robot, WheeledRobot

_BASES = {"Robot": Robot, "GroundRobot": GroundRobot, "WheeledRobot": WheeledRobot}


def _make(name):
    entry = data.ROBOTS[name]
    base = _BASES[entry["base"]]

    def __init__(self, name=None):  # pylint: disable=invalid-name
        base.__init__(self, entry["blend"], name)

    return type(name, (base,), {"__init__": __init__, "__module__": __name__,
                                "__doc__": "MORSE's %s." % name})


ATRV = _make("ATRV")
B21 = _make("B21")
Hummer = _make("Hummer")
Jido = _make("Jido")
QUAD2012 = _make("QUAD2012")
Quadrotor = _make("Quadrotor")
RMax = _make("RMax")
Submarine = _make("Submarine")
Pioneer3DX = _make("Pioneer3DX")
SegwayRMP400 = _make("SegwayRMP400")
PatrolBot = _make("PatrolBot")


class Morsy(_make("Morsy")):
    """MORSE's mascot."""

    def set_color(self, color=(0.0, 0.0, 0.8), *more):
        super().set_color(*(color if not more else (color,) + more))


class Victim(_make("Victim")):
    """MORSE's victim: somebody to be found and healed."""

    skills = ("heal",)


class FakeRobot(Robot):
    """A robot without a body: sensors at a place."""

    def __init__(self, name=None):
        super().__init__("", name)
        self.set_no_collision()

    def body_entry(self):
        return data.ROBOTS["FakeRobot"]
