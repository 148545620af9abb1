"""As much of the asyncore that Python had until 3.11 as pymorse uses, of our own making: sockets
that are asked in turn whether they can be read or written."""

import errno
import select
import socket

socket_map = {}

_LOST = {errno.ECONNRESET, errno.ENOTCONN, errno.ESHUTDOWN, errno.ECONNABORTED, errno.EPIPE,
         errno.EBADF}
_READ = select.POLLIN | select.POLLPRI
_END = select.POLLERR | select.POLLHUP | select.POLLNVAL


def _serve(channel, handler):
    try:
        handler()
    except OSError as error:
        if error.errno in _LOST:
            channel.handle_close()
        else:
            channel.handle_error()
    except Exception:  # what a callback raises is the channel's to judge
        channel.handle_error()


def poll(timeout=0.0, map=None):
    """Waits up to `timeout` s for any socket, and serves those that are ready."""
    channels = dict(socket_map if map is None else map)
    asked = select.poll()
    for number, channel in channels.items():
        flags = (_READ if channel.readable() else 0) | (select.POLLOUT if channel.writable() else 0)
        if flags:
            asked.register(number, flags)
    for number, flags in asked.poll(int(timeout * 1000.0)):
        channel = channels[number]
        if flags & _READ:
            _serve(channel, channel.handle_read)
        if flags & select.POLLOUT and channel.connected:
            _serve(channel, channel.handle_write)
        if flags & _END and channel.connected and not flags & _READ:
            channel.handle_close()


def loop(timeout=30.0, use_poll=False, map=None, count=None):
    """Serves until no socket is left, or `count` times."""
    channels = socket_map if map is None else map
    while channels and (count is None or count > 0):
        poll(timeout, channels)
        count = None if count is None else count - 1


def close_all(map=None, ignore_all=False):
    """Closes every socket."""
    channels = socket_map if map is None else map
    for channel in list(channels.values()):
        channel.close()
    channels.clear()


class dispatcher:
    """A connected socket of the map."""

    connecting = False

    def __init__(self, sock=None, map=None):
        self._map = socket_map if map is None else map
        self.connected = False
        self.socket = None
        if sock is not None:
            self.set_socket(sock)

    def set_socket(self, sock, map=None):
        sock.setblocking(False)
        self.socket = sock
        self._fileno = sock.fileno()
        self._map[self._fileno] = self
        self.connected = True

    def send(self, data):
        """How many bytes went; 0 where none can."""
        try:
            return self.socket.send(data)
        except (BlockingIOError, InterruptedError):
            return 0
        except OSError as error:
            if error.errno not in _LOST:
                raise
            self.handle_close()
            return 0

    def recv(self, size):
        """What there is; b"" where there is nothing, or nothing more."""
        try:
            data = self.socket.recv(size)
        except (BlockingIOError, InterruptedError):
            return b""
        if not data:
            self.handle_close()
        return data

    def close(self):
        self.connected = False
        self._map.pop(getattr(self, "_fileno", None), None)
        if self.socket is not None:
            try:
                self.socket.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass  # it was closed by the other end
            self.socket.close()

    def readable(self):
        return self.connected

    def writable(self):
        return False

    def handle_read(self):
        pass

    def handle_write(self):
        pass

    def handle_error(self):
        self.handle_close()

    def handle_close(self):
        self.close()
