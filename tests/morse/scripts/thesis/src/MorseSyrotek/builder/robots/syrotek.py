from morse.builder import *
from MorseSyrotek.builder.sensors import RobotProperties
from MorseSyrotek.builder.actuators import Pen

class Syrotek(GroundRobot):

    def __init__(self, name = None, debug = True):
        GroundRobot.__init__(
            self, 'MorseSyrotek/robots/syrotek.blend', name
        )

        self.properties(
            classpath = "MorseSyrotek.robots.Syrotek.Syrotek"
        )

        self.motion = MotionVW()
        self.append(self.motion)

        if debug:
            self.keyboard = Keyboard()
            self.keyboard.properties(ControlType = 'Position')
            self.append(self.keyboard)

        self.pose = Pose()
        self.append(self.pose)

        self.hokuyo = Hokuyo()
        self.hokuyo.translate(0.035, 0, 0)
        self.hokuyo.rotate(0, 0, 0)
        self.hokuyo.frequency(10)
        self.hokuyo.properties(
            Visible_arc = False, resolution = 0.39589, scan_window = 270,
            laser_range = 5.0, layer_offset = 0.125
        )
        self.append(self.hokuyo)

        self.odometry = Odometry()
        self.append(self.odometry)

        self.robotproperties = RobotProperties()
        self.append(self.robotproperties)

        self.waypoint = Waypoint()
        self.append(self.waypoint)

        self.pen = Pen()
        self.append(self.pen)
