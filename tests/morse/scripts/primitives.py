from morse.builder import *
from morse.builder.blenderobjects import *

ground = Plane('floor')
ground.scale = [10, 10, 1]
ground.color(0.1, 0.6, 0.1)

ball = Sphere()
ball.translate(z=1.0)
ball.scale = (0.5, 0.5, 0.5)
ball.color(1, 0, 0)

for shape in (Cube('c1'), IcoSphere('c2'), Cylinder('c3'), Cone('c4'), Torus('c5'), Empty('c6'),
              Coordsys('c7'), Spot('c8'), Camera('c9')):
    shape.translate(x=2)

robot = FakeRobot()
env = Environment('empty', fastmode=True)
