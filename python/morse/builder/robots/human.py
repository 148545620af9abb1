"""MORSE's human."""

from morse.builder.actuators import Armature
from morse.builder.morsebuilder import GroundRobot
from morse.builder.sensors import ArmaturePose


class Human(GroundRobot):
    """A person with a skeleton: the armature `skeleton`, its sensor `joint_states`."""

    skills = ("grasp",)

    def __init__(self, filename="human_rig", name=None):
        super().__init__(filename, name)
        self.properties(Animations=True)
        self.skeleton = Armature(armature_name="HumanSkeleton")
        self.skeleton.basename = None
        self.append(self.skeleton)
        self.joint_states = ArmaturePose()
        self.skeleton.append(self.joint_states)

    def add_interface(self, interface, **kwargs):
        self.joint_states.add_stream(interface, **kwargs)
        self.skeleton.add_service(interface)
        self.add_service(interface)
