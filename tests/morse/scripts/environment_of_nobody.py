from morse.builder import *

robot = ATRV()
env = Environment('i_do_not_exist')
