from morse.builder import *

robot = ATRV()
keyboard = Keyboard()
keyboard.properties(Speed=2.0)
robot.append(keyboard)
velocity = Velocity()
robot.append(velocity)
velocity.add_interface('socket')

env = Environment('empty', fastmode=True)
