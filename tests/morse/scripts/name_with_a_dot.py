from morse.builder import *

robot = ATRV()
robot.name = 'my.robot'
env = Environment('empty')
