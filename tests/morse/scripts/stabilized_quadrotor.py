from morse.builder import *

robot = QUAD2012()
robot.translate(z=1.0)
flight = StabilizedQuadrotor()
robot.append(flight)
flight.add_interface('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
