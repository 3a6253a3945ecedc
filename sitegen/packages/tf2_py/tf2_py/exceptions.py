"""The exceptions of a buffer: a transform is not available."""

# The names of upstream, which do not end in "Error".


class TransformException(Exception):
    """The base class of these exceptions."""


class ConnectivityException(TransformException):
    """Both frames exist, but no transforms connect them."""


class LookupException(TransformException):
    """A frame does not exist yet."""


class ExtrapolationException(TransformException):
    """A time is outside the buffered times."""


class InvalidArgumentException(TransformException):
    """A frame name is invalid."""


class TimeoutException(TransformException):
    """The transform was not available in time."""
