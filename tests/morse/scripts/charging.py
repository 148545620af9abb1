from morse.builder import *

robot = ATRV()
battery = Battery()
battery.properties(DischargingRate=20.0)
robot.append(battery)
motion = MotionVW()
robot.append(motion)
pose = Pose()
robot.append(pose)
robot.add_default_interface('socket')

zone = Zone(type='Charging')
zone.size = [1.0, 2.0, 3.0]
zone.translate(x=4.0)

env = Environment('empty', fastmode=True)
