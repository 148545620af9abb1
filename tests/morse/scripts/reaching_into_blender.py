from morse.builder import *

robot = RMax()
robot._bpy_object.location = (1.0, 2.0, 3.0)
robot._bpy_object.rotation_euler[2] = 0.5
robot._bpy_object.game.lock_location_z = True

pose = Pose()
robot.append(pose)
pose._bpy_object.location.z = 0.25
pose.add_interface('socket')

proximity = Proximity()
proximity.properties(Track='Found')
robot.append(proximity)
proximity.add_interface('socket')

other = RMax('other')
other.translate(x=4.0, y=6.0, z=3.0)
bpymorse.properties(bpymorse.get_object('other'), Found=True)

env = Environment('empty', fastmode=True)
