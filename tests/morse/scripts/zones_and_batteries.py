from morse.builder import *

robot = ATRV()
battery = Battery()
battery.properties(DischargingRate=10.0)
robot.append(battery)
battery.add_interface('socket')

zone = Zone(type='Charging')
zone.size = [2.0, 2.0, 2.0]
zone.translate(x=10)
zone.rotate(z=1.0)

env = Environment('empty', fastmode=True)
