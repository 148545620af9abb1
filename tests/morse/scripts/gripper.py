from morse.builder import *

robot = FakeRobot()
robot.translate(z=1.0)

gripper = Gripper('hand')
gripper.translate(x=0.5)
gripper.properties(Angle=180.0, Distance=2.0)
robot.append(gripper)
teleport = Teleport()
robot.append(teleport)
proximity = Proximity()
proximity.properties(Track='Graspable')
robot.append(proximity)
robot.add_default_interface('socket')

cup = PassiveObject('props/kitchen_objects', 'Cup')
cup.translate(x=1.5, z=1.0)
cup.setgraspable()

env = Environment('empty', fastmode=True)
