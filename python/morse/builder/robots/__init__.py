"""MORSE's robots."""

from morse.builder.robots.human import Human
from morse.builder.robots.morserobots import (ATRV, B21, FakeRobot, Hummer, Jido, Morsy, PatrolBot,
                                              Pioneer3DX, QUAD2012, Quadrotor, RMax, SegwayRMP400,
                                              Submarine, Victim)
from morse.builder.robots.pr2 import BarePR2, BasePR2, LocalizedPR2, NavPR2

__all__ = ["ATRV", "B21", "BarePR2", "BasePR2", "FakeRobot", "Human", "Hummer", "Jido",
           "LocalizedPR2", "Morsy", "NavPR2", "PatrolBot", "Pioneer3DX", "QUAD2012", "Quadrotor",
           "RMax", "SegwayRMP400", "Submarine", "Victim"]
