from morse.builder import *

robot = ATRV()
motion = MotionVW()
robot.append(motion)
motion.alter('Noise')
env = Environment('empty')
