#! /usr/bin/env morseexec
"""A robot that draws where it has been, by components of one's own (docs/components.md).

    ccmorse run examples/components/default.py
"""

from morse.builder import *

from drawing.builder.actuators import Pen
from drawing.builder.sensors import RobotProperties

robot = ATRV()
robot.properties(Owner='nobody')

motion = MotionVW()
robot.append(motion)

pose = Pose()
robot.append(pose)

pen = Pen()
robot.append(pen)

properties = RobotProperties()
properties.frequency(1)
properties.properties(ProxyIndex=3)
robot.append(properties)

robot.add_default_interface('socket')

env = Environment('empty', fastmode=True)
