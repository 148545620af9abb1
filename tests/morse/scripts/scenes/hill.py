"""An environment of one's own with a slope: from x = 2 up to 2 m at x = 6, level until x = 10."""
from morse.builder import *

robot = ATRV()
robot.translate(x=-2.0, z=0.1)
motion = MotionVW()
robot.append(motion)
pose = Pose()
robot.append(pose)
altimeter = RadarAltimeter()
altimeter.translate(z=1.0)
robot.append(altimeter)
gyroscope = Gyroscope()
robot.append(gyroscope)
laser = Sick()
laser.translate(z=0.4)
robot.append(laser)
robot.add_default_interface('socket')

other = ATRV()
other.translate(x=8.0, y=-1.0, z=5.0)  # comes down on the hill
where = Pose()
other.append(where)
other.add_default_interface('socket')

env = Environment('my_scene/environments/hill.obj')
