from morse.builder import *

robot = Submarine()
robot.translate(z=10.0)
push = ForceTorque()
robot.append(push)
push.add_stream('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')
velocity = Velocity()
robot.append(velocity)
velocity.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
