"""What services raise."""


class MorseError(Exception):
    """An error that a client is told."""

    def __init__(self, value=""):
        super().__init__(value)
        self.value = value

    def __str__(self):
        return str(self.value)


class MorseRPCInvokationError(MorseError):  # MORSE's spelling
    """The service cannot be done: the client gets FAILED and the text."""


class MorseRPCNoResultError(MorseRPCInvokationError):
    pass


class MorseMethodNotFoundError(MorseRPCInvokationError):
    pass


class MorseRPCTypeError(MorseRPCInvokationError):
    pass


class MorseServiceError(MorseError):
    pass


class MorseServiceAlreadyRunningError(MorseServiceError):
    pass


class MorseMiddlewareError(MorseError):
    pass
