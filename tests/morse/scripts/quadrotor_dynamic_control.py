from morse.builder import *

robot = Quadrotor()
robot.translate(z=500.0)
rotors = QuadrotorDynamicControl()
robot.append(rotors)
rotors.add_stream('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')
velocity = Velocity()
robot.append(velocity)
velocity.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
env.set_gravity(1.62)
