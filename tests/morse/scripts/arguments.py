import sys
from morse.builder import *

count = int(sys.argv[sys.argv.index('--') + 1])
print('making', count, 'robots')
for i in range(count):
    robot = FakeRobot('r%d' % i)
    robot.translate(x=i)
env = Environment('empty', fastmode=True)
