"""How simulated time advances (docs/morse.md)."""


class TimeStrategies:
    """Names of the strategies that Environment.set_time_strategy() takes."""

    BestEffort = 0  # keeps to real time
    FixedSimulationStep = 1  # as fast as possible, a fixed step each

    _NAMES = {0: ("BestEffort", "Best Effort"), 1: ("FixedSimulationStep", "Fixed Simulation Step")}

    @staticmethod
    def python_repr(strategy):
        """What to write in a script for it, as bytes."""
        return ("TimeStrategies." + TimeStrategies._NAMES[strategy][0]).encode()

    @staticmethod
    def human_repr(strategy):
        """What the service `time mode` calls it."""
        return TimeStrategies._NAMES[strategy][1]
