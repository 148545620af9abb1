from morse.builder import *
from morse.builder.sensors import *

robot = Jido()

hokuyo = Hokuyo()
hokuyo.translate(x=0.252, z=0.5)
robot.append(hokuyo)
hokuyo.properties(Visible_arc=True, laser_range=5.0, resolution=0.5)
hokuyo.frequency(5)
hokuyo.add_interface('socket')

sick = Sick()
sick.translate(x=0.3, z=0.3)
sick.rotate(0.0, 0.1, math.pi)
robot.append(sick)
sick.add_stream('socket')

many = SickLDMRS()
robot.append(many)

ir1 = Infrared()
ir1.translate(0.3, 0.2, 0.1)
ir1.properties(laser_range=1.5)
ir1.create_laser_arc()
ir1.properties(laser_range=9.0)
robot.append(ir1)

class Rear(Hokuyo):
    pass

rear = Rear()
rear.translate(z=0.4)
rear.rotate(z=math.pi)
rear.add_stream("socket")
robot.append(rear)

turning = VelodyneRayCast()
robot.append(turning)

env = Environment('indoors-1/boxes')
