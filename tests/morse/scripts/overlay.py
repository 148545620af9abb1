from morse.builder import *

robot = ATRV()
waypoint = Waypoint()
robot.append(waypoint)
waypoint.add_service('socket')
waypoint.add_overlay('socket', 'my_project.overlays.WaypointOverlay', namefrom='here')
env = Environment('empty')
