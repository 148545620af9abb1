from morse.builder import *

robot = ATRV()
pose = Pose()
pose.frequency(240)
robot.append(pose)
pose.add_stream('socket')
env = Environment('empty', fastmode=True)
env.simulator_frequency(50, 5, 5)
env.set_time_strategy(TimeStrategies.FixedSimulationStep)
env.use_relative_time(True)
