"""MORSE's PR2."""

from morse.builder.actuators import Armature, Keyboard, MotionXYW
from morse.builder.morsebuilder import GroundRobot
from morse.builder.sensors import IMU, ArmaturePose, CompoundSensor, Odometry, Pose, Sick


class BarePR2(GroundRobot):
    """The body only."""

    def __init__(self, name=None):
        super().__init__("pr2", name)

    def set_color(self, color=(0.0, 0.0, 0.8), *more):
        super().set_color(*(color if not more else (color,) + more))


class BasePR2(BarePR2):
    """With its torso, head and arms, each with the sensor `pose`, and `joint_state` of them all."""

    def __init__(self, name=None):
        super().__init__(name)
        self.torso = _armature("torso_armature")
        self.append(self.torso)
        self.torso_pose = _pose_of(self.torso)
        self.head = _armature("head_armature")
        self.l_arm = _armature("l_arm_armature")
        self.r_arm = _armature("r_arm_armature")
        for part in (self.head, self.l_arm, self.r_arm):
            self.torso.append(part)
        self.head_pose = _pose_of(self.head)
        self.l_arm_pose = _pose_of(self.l_arm)
        self.r_arm_pose = _pose_of(self.r_arm)
        self.joint_state = CompoundSensor(
            [self.torso_pose, self.head_pose, self.l_arm_pose, self.r_arm_pose])
        self.append(self.joint_state)

    def add_interface(self, interface, **kwargs):
        self.joint_state.add_stream(interface, method="PR2JointStatePublisher", **kwargs)
        for part in (self.torso, self.head, self.l_arm, self.r_arm):
            part.add_service(interface)


class LocalizedPR2(BasePR2):
    """With its pose and a motion besides."""

    def __init__(self, name=None, with_keyboard=True, show_laser=False):
        super().__init__(name)
        self.pose = Pose()
        self.append(self.pose)
        self.motion = MotionXYW()
        self.append(self.motion)
        if with_keyboard:
            self.keyboard = Keyboard()
            self.keyboard.properties(ControlType="Position")
            self.append(self.keyboard)

    def add_interface(self, interface, **kwargs):
        super().add_interface(interface, **kwargs)
        self.pose.add_stream(interface)
        self.motion.add_stream(interface)


class NavPR2(BasePR2):
    """With what it needs to find its way."""

    def __init__(self, name=None, with_keyboard=True, show_laser=False):
        super().__init__(name)
        self.base_scan = Sick()
        self.base_scan.translate(x=0.275, z=0.252)
        self.base_scan.properties(Visible_arc=show_laser, laser_range=30.0, resolution=1.0,
                                  scan_window=270.0)
        self.append(self.base_scan)
        self.odometry = Odometry()
        self.append(self.odometry)
        self.imu = IMU()
        self.append(self.imu)
        self.pose = Pose()
        self.append(self.pose)
        self.motion = MotionXYW()
        self.append(self.motion)
        if with_keyboard:
            self.keyboard = Keyboard()
            self.keyboard.properties(ControlType="Position")
            self.append(self.keyboard)

    def add_interface(self, interface, **kwargs):
        super().add_interface(interface, **kwargs)
        for part in (self.base_scan, self.odometry, self.imu, self.pose, self.motion):
            part.add_stream(interface)


def _armature(name):
    made = Armature(armature_name=name)
    made.basename = None  # it is named by the attribute that holds it
    return made


def _pose_of(armature):
    pose = ArmaturePose("pose")
    armature.append(pose)
    return pose
