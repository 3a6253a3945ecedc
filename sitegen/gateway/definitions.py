"""The text that defines a message together with those in it."""

from __future__ import annotations

import functools

from sitegen.gateway.fieldtypes import parse
from sitegen.gateway.native import UnknownTypeError, definition, load_type

LINE = "=" * 80


@functools.cache
def full_text(type_name: str) -> str:
    """Return the definition of a message, followed by those of the messages in it.

    Where definitions are not installed, the text says so.
    """
    text = ""
    left, seen = [type_name], set[str]()
    try:
        # The order of rosapi: the last message of each message first.
        while left:
            name = left.pop()
            package, _, short = name.split("/")
            text += f"\n{LINE}\nMSG: {package}/{short}\n" if text else ""
            text += definition(name)
            for each in load_type(name).get_fields_and_field_types().values():
                message = parse(each).message
                if message and message not in seen:
                    seen.add(message)
                    left.append(message)
    except UnknownTypeError as error:
        return f"# {error}"
    return text
