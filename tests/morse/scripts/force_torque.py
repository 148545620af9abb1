from morse.builder import *

robot = ATRV()
robot.translate(x=1.0, z=500.0)
push = ForceTorque()
push.properties(RobotFrame=True)
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
