from morse.builder import *

robot = ATRV()
rescuer = SearchAndRescue()
rescuer.properties(Heal_range=3.0, Abilities="1,2,3")
robot.append(rescuer)
motion = MotionVW()
robot.append(motion)
robot.add_default_interface('socket')

victim = Victim()
victim.translate(x=2.5)

one_of_three = Victim()
one_of_three.translate(x=9.0, y=4.0)
one_of_three.properties(Requirements="7", Severity=3)

env = Environment('empty', fastmode=True)
