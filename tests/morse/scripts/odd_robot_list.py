from morse.builder import *

robots = [FakeRobot() for i in range(3)]
for i, r in enumerate(robots):
    r.translate(x=i * 2.0)
    pose = Pose()
    r.append(pose)
env = Environment('empty', fastmode=True)
