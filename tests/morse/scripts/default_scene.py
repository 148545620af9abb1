#! /usr/bin/env morseexec

from morse.builder import *

robot = Morsy()
robot.translate(1.0, 0.0, 0.0)
robot.rotate(0.0, 0.0, 3.5)

motion = MotionVW()
robot.append(motion)

keyboard = Keyboard()
robot.append(keyboard)
keyboard.properties(ControlType = 'Position')

pose = Pose()
robot.append(pose)

robot.add_default_interface('socket')

env = Environment('sandbox', fastmode = False)
env.set_camera_location([-18.0, -6.7, 10.8])
env.set_camera_rotation([1.09, 0, -1.14])
