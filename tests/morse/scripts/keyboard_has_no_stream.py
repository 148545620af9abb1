from morse.builder import *

robot = ATRV()
keyboard = Keyboard()
robot.append(keyboard)
keyboard.add_stream('socket')
env = Environment('empty')
