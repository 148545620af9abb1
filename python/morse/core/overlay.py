"""The services of a component in another form, under another name."""

from functools import partial

from morse.core import status
from morse.core.abstractobject import AbstractObject
from morse.core.exceptions import MorseRPCInvokationError
from morse.helpers.transformation import Transformation3d


class MorseOverlay(AbstractObject):
    """What classes of add_overlay() derive from: its services call those of `overlaid_object`.

    A service of the component that answers later takes chain_callback() before its own arguments.
    """

    def __init__(self, overlaid_object):
        AbstractObject.__init__(self)
        self.overlaid_object = overlaid_object

    def name(self):
        """What clients call it by; asked once, at the start."""
        return type(self).__name__

    def interrupt(self):
        """Called when the running service is to end: ends that of the component."""
        self.overlaid_object.interrupt()

    def chain_callback(self, fn=None):
        """Something that ends the running service as the component's one that it is given to ends.

        fn((status, result)) returns the status and the result to end with instead.
        """
        running = self._running

        def done(result):
            if fn is not None:
                try:
                    result = fn(result)
                    status_code, value = result
                except Exception as error:  # the caller is not left without an answer
                    self.logger.exception("%s: what was chained has failed", self.name())
                    status_code = status.FAILED
                    value = "%s: %s" % (type(error).__name__, error)
            else:
                status_code, value = result
            # It may have been ended since, and another one may run.
            if running is not None and self._running is running:
                self.completed(status_code, value)

        return done


def _with_callback(service, start, callback, *arguments):
    if not callable(callback):
        raise TypeError("%s answers later: chain_callback() comes before its arguments" % service)
    start(callback, *arguments)


class OverlaidComponent:
    """A component of the simulator's: its services are methods of these names."""

    def __init__(self, birth, robot, state):
        self._birth = birth
        self._state = state
        self.robot_parent = robot

    def name(self):
        """Its full name, "robot.component"."""
        return self._birth["name"]

    @property
    def local_data(self):
        """A sensor's data, as they are now."""
        return self.get_local_data()

    @property
    def position_3d(self):
        """Where it is in the world, as long as nothing on its robot moves it."""
        mount = Transformation3d.of(self._birth["mount"], self._birth["mount_euler"])
        return self.robot_parent.position_3d.times(mount)

    def interrupt(self):
        """Ends its running service as PREEMPTED."""
        self._ask(["", "interrupt", [self.name()]])

    def __getattr__(self, service):
        if service.startswith("_") or service not in self._birth["services"]:
            raise AttributeError("%s has no service %r" % (self._birth["name"], service))
        if self._birth["services"][service]:
            return partial(_with_callback, service, partial(self._start, service))
        return partial(self._call, service)

    def _ask(self, question):
        answer = self._state.ask(question)
        if "failed" in answer:
            raise MorseRPCInvokationError(answer["failed"])
        return answer

    def _call(self, service, *arguments):
        return self._ask([self.name(), service, list(arguments)]).get("result")

    def _start(self, service, callback, *arguments):
        number = self._state.keep(callback)
        try:
            answer = self._ask([self.name(), service, list(arguments), self._birth["overlay"],
                                number])
        except BaseException:
            self._state.callbacks.pop(number)
            raise
        if "ended" in answer:
            self._state.callbacks.pop(number)(tuple(answer["ended"]))


class OverlaidOwn:
    """A component of one's own, which runs in the same process: all of it is there."""

    def __init__(self, component, services):
        self.__dict__.update(_component=component, _services=services)

    def __getattr__(self, name):
        method = self._services.get(name)
        if method is None:
            return getattr(self._component, name)
        bound = getattr(self._component, method.__name__)
        if not method._morse_asynchronous:
            return bound
        return partial(_with_callback, name, partial(self._start, bound))

    def __setattr__(self, name, value):
        setattr(self._component, name, value)

    def _start(self, method, callback, *arguments):
        self._component._begin(method, arguments, callback)
