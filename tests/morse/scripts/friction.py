from morse.builder import *

robot = ATRV()
robot.set_friction(5.0)
motion = MotionVW()
robot.append(motion)
motion.add_interface('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')

morsy = Morsy()
morsy.translate(y=5.0)
morsy.set_rigid_body()
drive = MotionVW()
morsy.append(drive)
drive.add_interface('socket')
airspeed = Airspeed()
morsy.append(airspeed)
airspeed.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
