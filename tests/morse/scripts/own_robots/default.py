from morse.builder import *
from own_robots.builder.robots import Scout

alpha = Scout()
alpha.translate(x=1.0)
beta = Scout(reach=4.0)
beta.translate(x=1.0, y=9.0)
beta.rotate(z=math.pi)

env = Environment('empty', fastmode=True)
