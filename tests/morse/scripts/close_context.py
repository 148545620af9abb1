from morse.builder import *

def two_of_a_kind():
    leader = ATRV()
    leader.translate(y=4)
    follower = ATRV()
    follower.translate(y=-4)
    for robot in (leader, follower):
        odometry = Odometry()
        robot.append(odometry)
        odometry.add_stream('socket')
    AbstractComponent.close_context()

two_of_a_kind()
env = Environment('empty')
