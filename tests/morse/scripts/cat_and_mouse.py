# Two robots of one kind, each with components of its own.
from morse.builder import *

# the mouse, driven by hand
mouse = ATRV()
mouse.translate(x=1.0, y=-3.0, z=0.2)
mouse.properties(Object=True, Graspable=False, Label="MOUSE")

keyboard = Keyboard()
keyboard.properties(Speed=3.0)
mouse.append(keyboard)

pose = Pose()
mouse.append(pose)
pose.add_stream('socket')

# the cat, which sees it
cat = SegwayRMP400()
cat.translate(x=-6.0, z=0.2)

motion = MotionVW()
cat.append(motion)
motion.add_stream('socket')

semanticL = SemanticCamera()
semanticL.translate(x=0.2, y=0.3, z=0.9)
cat.append(semanticL)

semanticR = SemanticCamera()
semanticR.translate(x=0.2, y=-0.3, z=0.9)
cat.append(semanticR)

semanticL.add_stream('socket')
semanticR.add_stream('socket')

env = Environment('land-1/trees')
env.place_camera([10.0, -10.0, 10.0])
env.aim_camera([1.0470, 0, 0.7854])
env.select_display_camera(semanticL)
