from morse.builder import *

morsy = Morsy()
atrv = ATRV()
b21 = B21()
jido = Jido()
hummer = Hummer()
pioneer = Pioneer3DX()
segway = SegwayRMP400()
patrol = PatrolBot()
victim = Victim()
human = Human()
quad = QUAD2012()
quadrotor = Quadrotor()
rmax = RMax()
submarine = Submarine()
fake = FakeRobot()
pr2 = NavPR2(with_keyboard=False)
bare = BarePR2()

row = [morsy, atrv, b21, jido, hummer, pioneer, segway, patrol, victim, human, quad, quadrotor, rmax,
       submarine, fake, pr2, bare]
for number, robot in enumerate(row):
    robot.translate(x=-50 + 7.0 * number, z=1.0)
    robot.add_default_interface('socket')
segway.unparent_wheels()

env = Environment('outdoors')
