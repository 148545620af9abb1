"""MORSE's outdoors, whose ground is a landscape."""
from morse.builder import *

robot = ATRV()
robot.translate(x=0.0, y=0.0, z=1.0)
motion = MotionVW()
robot.append(motion)
pose = Pose()
robot.append(pose)
altimeter = RadarAltimeter()
altimeter.translate(z=1.0)
robot.append(altimeter)
robot.add_default_interface('socket')

env = Environment('outdoors')
env.set_camera_location([-12.0, -16.0, 12.0])
env.set_camera_rotation([1.05, 0.0, -0.65])
