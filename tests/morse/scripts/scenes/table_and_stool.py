"""A laser looks at the edges of things from a file of one's own, in the project's data folder."""
from morse.builder import *

robot = ATRV()
high = Sick()
high.translate(z=0.62)  # 0.72 m above the ground: the table's top
robot.append(high)
low = Sick()
low.translate(z=0.2)  # its leg
robot.append(low)
near = Proximity()
near.properties(Track='Object')
robot.append(near)
motion = MotionVW()
robot.append(motion)
collision = Collision()
robot.append(collision)
pose = Pose()
robot.append(pose)
robot.add_default_interface('socket')

table = PassiveObject('my_scene/props/table.obj', 'T')
table.translate(x=3.0)
table.properties(Object=True, Label='THE TABLE')
leg = PassiveObject('my_scene/props/table.obj', 'Leg')
leg.translate(x=3.0)
stool = PassiveObject('my_scene/props/table.obj', 'Stool', keep_pose=True)
stool.translate(x=-4.0)  # in the file it stands from x = 1 to 1.4
stool.setgraspable()

env = Environment('empty')
