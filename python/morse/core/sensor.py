"""What sensors of one's own derive from."""

from morse.core.object import Object


class Sensor(Object):
    """Its default_action() fills local_data; then they are sent."""
