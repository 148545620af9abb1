from morse.builder import *

robot = Quadrotor()
robot.translate(z=400.0)
drag = Drag()
drag.properties(DragCoeffZ=2.0)
robot.append(drag)
velocity = Velocity()
robot.append(velocity)
velocity.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
