from morse.builder import *

class Survey():
    def set_up(self):
        first = ATRV()
        first.name = 'renamed'
        second = ATRV('given')
        second.translate(y=5.0)
        third = ATRV()
        third.translate(y=10.0)
        for robot in (first, second, third):
            where = Pose('spot')
            robot.append(where)
            again = Pose()
            again.name = 'spot'
            robot.append(again)
            robot.add_default_interface('socket')
        del robot
        env = Environment('empty', fastmode=True)

Survey().set_up()
