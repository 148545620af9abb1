from morse.builder import *


class Scout(ATRV):
    """A robot with all that a scout needs."""

    def __init__(self, name=None, reach=12.0):
        ATRV.__init__(self, name)
        self.properties(classpath="own_robots.robots.scout.Scout")
        self.motion = MotionVW()
        self.append(self.motion)
        self.pose = Pose()
        self.pose.translate(z=0.5)
        self.append(self.pose)
        self.scanner = Hokuyo()
        self.scanner.properties(laser_range=reach, resolution=1.0, scan_window=90.0)
        self.scanner.create_laser_arc()
        self.scanner.translate(x=0.6, z=0.4)
        self.append(self.scanner)
        self.add_default_interface('socket')
