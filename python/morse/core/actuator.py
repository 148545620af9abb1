"""What actuators of one's own derive from."""

from morse.core.object import Object


class Actuator(Object):
    """Its default_action() does what local_data, which clients send, want done."""
