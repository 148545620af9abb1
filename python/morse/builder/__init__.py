"""MORSE's builder: `from morse.builder import *` begins a scene (docs/morse.md)."""

from morse.builder.abstractcomponent import *  # noqa: F401,F403
from morse.builder.morsebuilder import *  # noqa: F401,F403
from morse.builder.environment import *  # noqa: F401,F403
from morse.builder.robots import *  # noqa: F401,F403
from morse.builder.actuators import *  # noqa: F401,F403
from morse.builder.sensors import *  # noqa: F401,F403
from morse.core.morse_time import TimeStrategies  # noqa: F401
