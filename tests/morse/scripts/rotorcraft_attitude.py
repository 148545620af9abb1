from morse.builder import *

robot = Quadrotor()
robot.translate(z=500.0)
attitude = RotorcraftAttitude()
robot.append(attitude)
attitude.add_interface('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')
velocity = Velocity()
robot.append(velocity)
velocity.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
