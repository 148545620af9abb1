import morse.core.sensor
from morse.core import status
from morse.core.services import async_service, interruptible, service
from morse.helpers.components import add_data, add_property


class Counter(morse.core.sensor.Sensor):
    add_data('sum', 0, 'int', 'of all that was added')
    add_property('_step', 1, 'Step', 'int', 'what an activation adds')

    def __init__(self, obj, parent=None):
        super().__init__(obj, parent)
        self._goal = 0

    @service
    def add(self, number):
        self.local_data['sum'] += number
        return number + self._step

    @interruptible
    @async_service
    def count_up(self, more):
        self._goal = self.local_data['sum'] + more

    def default_action(self):
        self.local_data['sum'] += self._step
        if self.on_completion and self.local_data['sum'] >= self._goal:
            self.completed(status.SUCCESS, self.local_data['sum'])
