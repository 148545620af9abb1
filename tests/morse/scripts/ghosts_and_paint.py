from morse.builder import *

ghost = ATRV()
ghost.make_ghost()
ghost.set_color(1.0, 0.0, 0.0)

heavy = Morsy()
heavy.translate(y=5.0)
heavy.set_mass(33.5)
heavy.set_friction(2.0)
heavy.set_color((0.0, 1.0, 0.0))
heavy.set_rigid_body()
heavy.set_collision_bounds()
env = Environment('empty', fastmode=True)
