from morse.builder import *

robot = ATRV()
