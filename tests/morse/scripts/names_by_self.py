from morse.builder import *

class Patrol(ATRV):
    def __init__(self, name=None):
        ATRV.__init__(self, name)
        self.where = Pose()
        self.append(self.where)
        self.go = MotionVW()
        self.append(self.go)
        self.where.add_stream('socket')
        self.go.add_service('socket')

walker = Patrol()
env = Environment('empty', fastmode=True)
