"""The interface of buffers, and the registries of transformations and conversions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.time import Time


class TypeException(Exception):
    """No transformation or conversion is registered for a type."""


class NotImplementedException(Exception):
    """The buffer does not implement this method."""

    def __init__(self) -> None:
        super().__init__("CanTransform or LookupTransform not implemented")


Transforming = Callable[[Any, TransformStamped], Any]


class TransformRegistration:
    """The functions that transform data, by type."""

    _functions: ClassVar[dict[type, Transforming]] = {}

    def print_me(self) -> None:
        """Print the registered types."""
        print(self._functions)

    def add(self, key: type, callback: Transforming) -> None:
        """Register the function that transforms data of a type."""
        self._functions[key] = callback

    def get(self, key: type) -> Transforming:
        """Return the function that transforms data of a type.

        Raises:
            TypeException: if there is none.
        """
        if key not in self._functions:
            raise TypeException(f"Type {key} is not loaded or supported")
        return self._functions[key]


class ConvertRegistration:
    """The functions that convert types to messages, from messages, and to each other."""

    _to_msg: ClassVar[dict[type, Callable[[Any], Any]]] = {}
    _from_msg: ClassVar[dict[type, Callable[[Any], Any]]] = {}
    _convert: ClassVar[dict[tuple[type, type], Callable[[Any], Any]]] = {}

    def add_from_msg(self, key: type, callback: Callable[[Any], Any]) -> None:
        """Register the conversion of a type from its message."""
        self._from_msg[key] = callback

    def add_to_msg(self, key: type, callback: Callable[[Any], Any]) -> None:
        """Register the conversion of a type to its message."""
        self._to_msg[key] = callback

    def add_convert(self, key: tuple[type, type], callback: Callable[[Any], Any]) -> None:
        """Register the conversion of one type to another."""
        self._convert[key] = callback

    def get_from_msg(self, key: type) -> Callable[[Any], Any]:
        """Return the conversion of a type from its message."""
        return _of(self._from_msg, key)

    def get_to_msg(self, key: type) -> Callable[[Any], Any]:
        """Return the conversion of a type to its message."""
        return _of(self._to_msg, key)

    def get_convert(self, key: tuple[type, type]) -> Callable[[Any], Any]:
        """Return the conversion of one type to another, or None."""
        return _of(self._convert, key)


def _of(functions: dict[Any, Callable[[Any], Any]], key: Any) -> Callable[[Any], Any]:
    if key not in functions:
        raise TypeException(f"Type {key} is not loaded or supported")
    return functions[key]


def convert(a: Any, b_type: type) -> Any:
    """Convert `a` to another type, through a message if there is no direct conversion."""
    known = ConvertRegistration()
    if isinstance(a, b_type):
        return a
    try:
        return known.get_convert((type(a), b_type))(a)
    except TypeException:
        return known.get_from_msg(b_type)(known.get_to_msg(type(a))(a))


class Stamped:
    """Data with a frame and a time."""

    def __init__(self, obj: Any, stamp: Time, frame_id: str) -> None:
        self.obj = obj
        self.stamp = stamp
        self.frame_id = frame_id


class BufferInterface:
    """Transforms data with a header."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self,
        object_stamped: Any,
        target_frame: str,
        timeout: Duration = Duration(),  # noqa: B008 (it never changes)
        new_type: type | None = None,
    ) -> Any:
        """Return data with a header, transformed to another frame."""
        act = self.registration.get(type(object_stamped))
        header = object_stamped.header
        time = Time.from_msg(header.stamp)
        found = self.lookup_transform(target_frame, header.frame_id, time, timeout)
        result = act(object_stamped, found)
        return convert(result, new_type) if new_type else result

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Time,
        fixed_frame: str,
        timeout: Duration = Duration(),  # noqa: B008
        new_type: type | None = None,
    ) -> Any:
        """Return data with a header, transformed to another frame and time."""
        act = self.registration.get(type(object_stamped))
        header = object_stamped.header
        time = Time.from_msg(header.stamp)
        found = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, time, fixed_frame, timeout
        )
        result = act(object_stamped, found)
        return convert(result, new_type) if new_type else result

    def lookup_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Time,
        timeout: Duration = Duration(),  # noqa: B008
    ) -> TransformStamped:
        """Return the transform; implemented by buffers."""
        raise NotImplementedException

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Time,
        source_frame: str,
        source_time: Time,
        fixed_frame: str,
        timeout: Duration = Duration(),  # noqa: B008
    ) -> TransformStamped:
        """Return the transform between two times; implemented by buffers."""
        raise NotImplementedException
