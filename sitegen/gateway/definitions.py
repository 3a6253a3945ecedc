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
    parts: list[str] = []
    waiting, seen = [type_name], {type_name}
    try:
        while waiting:
            name = waiting.pop(0)
            text = definition(name)
            package, _, short = name.split("/")
            parts.append(text if not parts else f"{LINE}\nMSG: {package}/{short}\n{text}")
            for each in load_type(name).get_fields_and_field_types().values():
                message = parse(each).message
                if message and message not in seen:
                    seen.add(message)
                    waiting.append(message)
    except UnknownTypeError as error:
        return f"# {error}"
    return "\n".join(parts)
