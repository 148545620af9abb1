"""MORSE's decorators of services."""


def service(fn=None, component=None, name=None, asynchronous=False):
    """A method that clients call. Its result is the answer.

    With `asynchronous` the answer is what it hands on to completed() later.
    """
    def mark(method):
        method._morse_service = name or method.__name__
        method._morse_asynchronous = asynchronous
        return method
    return mark(fn) if callable(fn) else mark


def async_service(fn=None, component=None, name=None):
    """A method that starts something; completed() ends it. One at a time for each component."""
    def mark(method):
        return service(method, name=name, asynchronous=True)
    return mark(fn) if callable(fn) else mark


def interruptible(fn):
    """Called while a service of its component runs, it ends that one as PREEMPTED."""
    fn._morse_policy = "interruptible"
    return fn


def noninterruptible(fn):
    """Called while a service of its component runs, it fails."""
    fn._morse_policy = "noninterruptible"
    return fn
