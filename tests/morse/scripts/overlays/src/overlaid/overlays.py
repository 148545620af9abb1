from morse.core import status
from morse.core.exceptions import MorseRPCInvokationError
from morse.core.overlay import MorseOverlay
from morse.core.services import async_service, interruptible, service


class Guide(MorseOverlay):
    """A Waypoint with a service of its own form."""

    def __init__(self, overlaid_object, slowness=1.0):
        super().__init__(overlaid_object)
        self.slowness = slowness
        self.ways = 0

    def name(self):
        return 'guide'

    @interruptible
    @async_service
    def walk(self, x, y, speed=2.0):
        self.overlaid_object.goto(self.chain_callback(self.arrived), x, y, 0.0, 0.2,
                                  speed / self.slowness)

    def arrived(self, result):
        state, value = result
        if state == status.SUCCESS:
            self.ways += 1
            return state, "way %d" % self.ways
        return result

    @interruptible
    @async_service
    def plain(self, x, y):
        self.overlaid_object.goto(self.chain_callback(), x, y, 0.0, 0.2, 1.0)

    @async_service
    def without_a_callback(self):
        self.overlaid_object.goto(1.0, 2.0)

    @service
    def halt(self):
        return self.overlaid_object.stop()

    @service
    def where_to(self):
        return self.overlaid_object.get_properties()["properties"]["Speed"][0]


class Where(MorseOverlay):
    """Named by its class."""

    @service(name='in_millimetres')
    def scaled(self, axis='x'):
        return round(1000.0 * self.overlaid_object.local_data[axis])

    @service
    def who(self):
        here = self.overlaid_object.position_3d
        return [self.overlaid_object.name(), self.overlaid_object.robot_parent.name(),
                round(here.x, 6), round(here.z, 6)]

    @service
    def fly(self):
        return self.overlaid_object.fly()

    @service
    def push(self):
        self.overlaid_object.robot_parent.apply_speed('Velocity', [1.0, 0.0, 0.0], [0.0, 0.0, 0.0])


class Eye(MorseOverlay):
    """Its name is given by the script."""

    def __init__(self, overlaid_object, named):
        super().__init__(overlaid_object)
        self.named = named

    def name(self):
        return self.named

    @service
    def look_as_far_as(self, metres):
        self.overlaid_object.set_range(metres)
        return self.overlaid_object.get_configurations()["configurations"]["Range"]

    @service
    def refuse(self):
        raise MorseRPCInvokationError("not with me")


class Clerk(MorseOverlay):
    """On a component of one's own."""

    def name(self):
        return 'clerk'

    @service
    def twice(self, number):
        return 2 * self.overlaid_object.add(number)

    @interruptible
    @async_service
    def wait_for(self, more):
        self.overlaid_object.count_up(self.chain_callback(), more)

    @service
    def drive(self, speed):
        self.overlaid_object.apply_speed('Velocity', [speed, 0.0, 0.0], [0.0, 0.0, 0.0])
