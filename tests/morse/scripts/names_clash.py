from morse.builder import *

first = FakeRobot('m')
first.translate(x=2)
second = FakeRobot('m')
second.translate(x=4)
third = FakeRobot('m')
third.translate(x=6)
env = Environment('empty', fastmode=True)
