"""The thesis's Pen (L. Bertl, 2017, section 4.2.1): draws on the grid map that lies on the floor."""

import morse.core.actuator
from morse.core import status
from morse.core.services import async_service, interruptible, service
from morse.helpers.components import add_data, add_property


class Pen(morse.core.actuator.Actuator):
    """Draws where its robot goes while it is down, and what services ask for.

    Cells count from the bottom-left corner of the world, colours from 0 to 255, alpha from 0 to 1.
    """
    _name = "Pen"
    _short_desc = "Draws on the canvas."

    add_data('down', False, 'bool', 'draws a trace of the robot')

    add_property('_red', 200, 'Red', 'int', 'of the trace, 0 to 255')
    add_property('_green', 30, 'Green', 'int', 'of the trace, 0 to 255')
    add_property('_blue', 30, 'Blue', 'int', 'of the trace, 0 to 255')

    def __init__(self, obj, parent=None):
        morse.core.actuator.Actuator.__init__(self, obj, parent)
        self._waiting = []  # cells that plot has yet to draw

    @service
    def set_pixel(self, x, y, r, g, b, alpha=1.0):
        self.canvas.set_pixel(x, y, (r, g, b), alpha)

    @service
    def draw_line(self, x0, y0, x1, y1, r, g, b, alpha=1.0):
        self.canvas.draw_line(x0, y0, x1, y1, (r, g, b), alpha)

    @service
    def get_pixel(self, x, y):
        return self.canvas.get_pixel(x, y)

    @service
    def get_cell_size(self):
        """m"""
        return self.canvas.cell_size

    @service
    def clear(self):
        self.canvas.clear()

    @interruptible
    @async_service
    def plot(self, cells):
        """Draws a list of [x, y], one each time that the pen is due; answers when all are there."""
        self._waiting = list(cells)

    def default_action(self):
        color = (self._red, self._green, self._blue)
        if self.local_data['down']:
            self.canvas.set_pixel(*self.canvas.cell_at(self.position_3d.x, self.position_3d.y),
                                  color)
        if self._waiting:
            self.canvas.set_pixel(*self._waiting.pop(0), color)
        elif self.on_completion:
            self.completed(status.SUCCESS, 'Plotted')
