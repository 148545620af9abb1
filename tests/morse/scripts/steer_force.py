from morse.builder import *

robot = Hummer()
car = SteerForce()
robot.append(car)
car.add_stream('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')
velocity = Velocity()
robot.append(velocity)
velocity.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
