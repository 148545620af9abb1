from morse.builder import *

robot = Quadrotor()
robot.translate(z=2.0)
waypoint = RotorcraftWaypoint()
robot.append(waypoint)
waypoint.add_interface('socket')
pose = Pose()
robot.append(pose)
pose.add_interface('socket')

env = Environment('empty', fastmode=True)
if 'fixed' in sys.argv:
    env.set_time_strategy(TimeStrategies.FixedSimulationStep)
