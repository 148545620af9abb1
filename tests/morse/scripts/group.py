from morse.builder import *

# Robots of one variable: rover, rover_001, rover_002.
for i in range(3):
    rover = ATRV()
    rover.translate(x=2.0, y=4.0 * i)
    rover.rotate(z=0.5 * i)
    motion = MotionVW()
    rover.append(motion)
    pose = Pose()
    rover.append(pose)
    rover.add_default_interface('socket')
    AbstractComponent.close_context()

env = Environment('empty', fastmode=True)
