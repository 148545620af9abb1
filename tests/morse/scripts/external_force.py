from morse.builder import *

robot = RMax()
robot.translate(z=10.0)
robot.rotate(z=math.pi / 2.0)
wind = ExternalForce()
robot.append(wind)
wind.add_stream('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')
velocity = Velocity()
robot.append(velocity)
velocity.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
