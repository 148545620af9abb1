from morse.builder import *

robot = ATRV()
table = PassiveObject('props/objects', 'SmallTable')
table.translate(x=3.5, y=-3, z=0)
table.rotate(z=0.2)
table.properties(Object=True, Label="THE TABLE")

cup = PassiveObject(filename='props/kitchen_objects', prefix='Cup', keep_pose=True)
cup.setgraspable()
env = Environment('indoors-1/indoor-1')
