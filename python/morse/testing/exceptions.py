"""What goes wrong around a test rather than in it."""


class MorseTestingError(Exception):
    """The simulation could not be started, or not be ended."""
