"""A robot with a model of one's own: its origin is 0.2 m above its lowest point."""
from morse.builder import *


class Rover(GroundRobot):
    def __init__(self, name=None):
        GroundRobot.__init__(self, 'my_scene/robots/rover.obj', name)


rover = Rover()
rover.translate(x=4.0)
motion = MotionVW()
rover.append(motion)
pose = Pose()
rover.append(pose)
rover.add_default_interface('socket')

watcher = ATRV()
high = Sick()
high.translate(z=0.6)  # 0.7 m: above its body, at its mast
watcher.append(high)
low = Sick()
low.translate(z=0.2)
watcher.append(low)
drive = MotionVW()
watcher.append(drive)
place = Pose()
watcher.append(place)
watcher.add_default_interface('socket')

env = Environment('empty')
