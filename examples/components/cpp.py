#! /usr/bin/env morseexec
"""A robot that draws where it has been, by a plug-in in C++ (docs/components.md).

    make -C examples/components/src/drawing/plugins
    ccmorse run examples/components/cpp.py
"""

from morse.builder import *

from drawing.builder.actuators import Brush

robot = ATRV()

motion = MotionVW()
robot.append(motion)

brush = Brush()
robot.append(brush)

robot.add_default_interface('socket')

env = Environment('empty', fastmode=True)
