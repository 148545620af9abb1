from morse.builder import *


class Casualty(Victim):
    """A victim of one's own is one, too."""


robot = ATRV()
rescuer = SearchAndRescue()
robot.append(rescuer)
robot.add_default_interface('socket')

victim = Victim()
victim.translate(x=2.5)
victim.add_service('socket')
casualty = Casualty()
casualty.translate(x=4.5)
casualty.add_service('socket')
silent = Victim()
silent.translate(x=-9.0)

human = Human()
human.translate(y=5.0)
teleport = Teleport()
human.append(teleport)
proximity = Proximity()
proximity.properties(Track='Graspable')
human.append(proximity)
human.add_default_interface('socket')
human.add_service('socket')

cup = PassiveObject('props/kitchen_objects', 'Cup')
cup.translate(x=0.6, y=5.0, z=0.0)
cup.setgraspable()
far_cup = PassiveObject('props/kitchen_objects', 'Cup')
far_cup.translate(x=8.0, y=5.0, z=0.0)
far_cup.setgraspable()

env = Environment('empty', fastmode=True)
