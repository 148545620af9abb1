from morse.builder import *

robot = ATRV()
pose = Pose()
robot.append(pose)
pose.add_stream('ros')
pose.add_stream('socket')
pose.add_stream('text', path='somewhere')
pose.add_stream('socket', 'morse.middleware.socket_datastream.SocketPublisher')
pose.add_stream('fax')
collision = Collision()
robot.append(collision)
collision.add_stream('socket')
env = Environment('empty', fastmode=True)
