"""As much of the asynchat that Python had until 3.11 as pymorse uses, of our own making: messages
that end with a terminator, over a socket of asyncore."""

import asyncore
from collections import deque


class async_chat(asyncore.dispatcher):
    """Collects what comes until the terminator, and sends what is pushed."""

    ac_in_buffer_size = 65536
    ac_out_buffer_size = 65536
    use_encoding = 0
    encoding = "latin-1"

    def __init__(self, sock=None, map=None):
        self._coming = b""
        self.terminator = None
        self.producer_fifo = deque()
        super().__init__(sock, map)

    def set_terminator(self, terminator):
        self.terminator = terminator

    def handle_read(self):
        self._coming += self.recv(self.ac_in_buffer_size)
        while self.terminator and self.terminator in self._coming:
            message, self._coming = self._coming.split(self.terminator, 1)
            self.collect_incoming_data(message)
            self.found_terminator()

    def handle_write(self):
        self.initiate_send()

    def push(self, data):
        for start in range(0, len(data), self.ac_out_buffer_size):
            self.producer_fifo.append(data[start:start + self.ac_out_buffer_size])
        self.initiate_send()

    def writable(self):
        return self.connected and bool(self.producer_fifo)

    def initiate_send(self):
        while self.producer_fifo and self.connected:
            first = self.producer_fifo.popleft()
            sent = self.send(first)
            if sent < len(first):
                self.producer_fifo.appendleft(first[sent:])
                return

    def collect_incoming_data(self, data):
        raise NotImplementedError

    def found_terminator(self):
        raise NotImplementedError
