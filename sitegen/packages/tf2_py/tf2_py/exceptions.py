"""What a buffer raises: nothing is wrong with the program, a transform is not there."""

# Upstream's names do not end in "Error".


class TransformException(Exception):
    """What all of these are."""


class ConnectivityException(TransformException):
    """Two frames are there, and no transforms lead from one to the other."""


class LookupException(TransformException):
    """Nobody has said anything about a frame yet."""


class ExtrapolationException(TransformException):
    """A time is outside of what is kept."""


class InvalidArgumentException(TransformException):
    """A name cannot be that of a frame."""


class TimeoutException(TransformException):
    """It took too long."""
