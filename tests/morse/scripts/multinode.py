from morse.builder import *

here = ATRV()
there = ATRV()
there.translate(x=5)
env = Environment('empty', fastmode=True)
env.configure_multinode(protocol='socket', server_address='localhost', server_port='65000',
                        distribution={'node A': [here.name], 'node B': [there.name]})
