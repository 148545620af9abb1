from morse.builder import *

robot = FakeRobot()
env = Environment('empty', fastmode=True)
env.set_time_scale(accelerate_by=4)
