"""Primitives are shown; a laser sees them where a script gives them physics."""
from morse.builder import *
from morse.builder.blenderobjects import *

robot = ATRV()
laser = Sick()
laser.translate(z=0.4)
robot.append(laser)
robot.add_default_interface('socket')

ghost = Cube('ghost')
ghost.scale = [0.5, 0.5, 0.5]
ghost.translate(x=3.0, z=0.5)
ghost.color(1, 0, 0)

wall = Cube('wall')
wall.scale = [0.5, 2.0, 1.0]
wall.translate(x=6.0, z=1.0)
wall._bpy_object.game.physics_type = 'STATIC'

ball = Sphere('ball')
ball.translate(y=5.0, z=0.5)
ball._bpy_object.game.physics_type = 'RIGID_BODY'

env = Environment('empty')
