from morse.builder import *

robot = ATRV()
robot.translate(x=1.0, y=2.0)
robot.rotate(z=math.pi / 2)

turret = PTU()
turret.translate(x=0.5, z=1.0)
turret.rotate(z=math.pi / 2)
robot.append(turret)

eye = Pose()
eye.translate(x=0.2)
eye.translate(y=0.1)
eye.rotate(y=0.3)
turret.append(eye)
eye.add_interface('socket')

beside = Pose()
beside.location = (0.0, -0.3, 0.4)
beside.rotation_euler = (0.1, 0.0, 0.0)
robot.append(beside)
beside.add_interface('socket')

motion = MotionVW()
robot.append(motion)
motion.add_interface('socket')

env = Environment('empty', fastmode=True)
