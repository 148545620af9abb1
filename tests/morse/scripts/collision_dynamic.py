from morse.builder import *

robot = ATRV()
robot.set_friction(0.5)
motion = MotionVW()
robot.append(motion)
motion.add_interface('socket')
collision = Collision()
robot.append(collision)
collision.add_interface('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')

other = Morsy()
other.translate(x=3.0)

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
