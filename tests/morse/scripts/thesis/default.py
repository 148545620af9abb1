#! /usr/bin/env morseexec
import os, sys, inspect

# Getting path to this folder
currentFolder = os.path.realpath(
    os.path.abspath( os.path.split(
        inspect.getfile( inspect.currentframe() )
    )[0])
)
if currentFolder not in sys.path:
    sys.path.insert(0, currentFolder)

# Setting path to environments blend file
environmentPath = os.path.join(
    currentFolder, 'data', 'MorseSyrotek', 'environments', 'arena.blend'
)
if environmentPath not in sys.path:
    sys.path.insert(0, environmentPath)

# Setting path to S1R robot folder
robotFolder = os.path.join(
    currentFolder, 'src', 'MorseSyrotek', 'builder', 'robots'
)
if robotFolder not in sys.path:
    sys.path.insert(0, robotFolder)

from morse.builder import *
from MorseSyrotek.builder.robots import Syrotek
from MorseSyrotek.builder.components import Canvas

canvasPath = os.path.join(currentFolder, 'data', 'MorseSyrotek', 'components', 'Canvas.blend')
canvas = Canvas(filename = canvasPath, alpha = 0.75)

robot = Syrotek()
robot.translate(1.2, 2.0, 0.0)
robot.rotate(0.0, 0.0, 2.6)
robot.add_default_interface('socket')

s1r_2 = Syrotek(debug = False)
s1r_2.translate(2.6, 2.4, 0.0)
s1r_2.add_default_interface('socket')

env = Environment(filename = environmentPath, fastmode = False)
env.set_camera_location([1.71, 1.86, 5.5])
env.set_camera_rotation([0, 0, 0])
