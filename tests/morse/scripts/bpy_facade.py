from morse.builder import *

robot = QUAD2012()
robot.translate(z=2.5)
robot._bpy_object.game.lock_location_z = True
robot._bpy_object.location[0] = 1.5
assert robot.location[2] == 2.5 and robot.location.x == 1.5

thing = PassiveObject('props/objects', 'SmallTable')
target = bpymorse.get_object('SmallTable')
target.game.use_actor = True
target.scale = (0.1, 0.1, 0.1)
bpymorse.properties(target, Object=True, Label='T', Weight=1.5, Count=3)
assert target.game.properties['Weight'].type == 'FLOAT'
assert target.game.properties['Count'].type == 'INT'
assert thing.property_value('Label') == 'T'
assert thing.scale[0] == 0.1

env = Environment('empty', fastmode=True)
