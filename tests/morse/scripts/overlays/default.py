from morse.builder import *
from morse.builder.creator import SensorCreator


class Counter(SensorCreator):
    _classpath = 'overlaid.sensors.Counter'


robot = ATRV()
waypoint = Waypoint()
robot.append(waypoint)
pose = Pose()
pose.translate(x=0.5)
robot.append(pose)
proximity = Proximity()
robot.append(proximity)
counter = Counter()
robot.append(counter)
robot.add_default_interface('socket')

waypoint.add_overlay('socket', 'overlaid.overlays.Guide', slowness=2.0)
pose.add_overlay('socket', 'overlaid.overlays.Where')
proximity.add_overlay('socket', 'overlaid.overlays.Eye', named='eye')
counter.add_overlay('socket', 'overlaid.overlays.Clerk')

env = Environment('empty', fastmode=True)
