from morse.builder import *

robot = Pioneer3DX()
motion = MotionVWDiff()
robot.append(motion)
motion.add_interface('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')

segway = SegwayRMP400()
segway.translate(y=5.0)
drive = MotionVWDiff()
segway.append(drive)
drive.add_interface('socket')
place = Pose()
segway.append(place)
place.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
