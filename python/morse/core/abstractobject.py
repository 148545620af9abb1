"""What all that runs in a simulation has: services and their ends."""

import logging

from morse.core import status
from morse.core.exceptions import MorseServiceAlreadyRunningError


class AbstractObject:
    """Something with services. The simulator calls its action(); see docs/components.md."""

    _name = ""
    _short_desc = ""

    def __init__(self):
        self._running = None  # (ticket, name) of the service that answers later
        self._ended = []  # [ticket, status, result]
        self.logger = logging.getLogger("morse." + type(self).__name__)

    @property
    def on_completion(self):
        """Whether a service runs; None where none does."""
        return self._running

    def completed(self, status_code, result=None):
        """Ends the running service with this status and result."""
        if self._running is None:
            return
        if status_code not in (status.SUCCESS, status.FAILED, status.PREEMPTED):
            raise ValueError("no status is called %r" % (status_code,))
        self._ended.append([self._running[0], status_code, result])
        self._running = None

    def interrupt(self):
        """Called when the running service is to end. Who overrides it calls it at the end."""
        self.completed(status.PREEMPTED)

    def _begin(self, method, arguments, ticket):
        if self._running is not None:
            running = self._running[1]
            policy = getattr(method, "_morse_policy", None)
            if policy == "interruptible":
                self.interrupt()
                self.completed(status.PREEMPTED)  # where interrupt() has not
            elif policy == "noninterruptible":
                raise MorseServiceAlreadyRunningError(
                    "A non-interruptible service (%s) is already running" % running)
            else:
                raise MorseServiceAlreadyRunningError(
                    "A service (%s) is already running. I do not know what to do." % running)
        self._running = (ticket, method._morse_service)
        try:
            method(*arguments)
        except BaseException:
            self._running = None
            raise

    def default_action(self):
        """What happens each time that it is due."""

    def action(self):
        self.default_action()

    def finalize(self):
        """Called when the simulation ends."""
