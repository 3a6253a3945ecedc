"""Read site.yaml, and the Markdown files that it names, into a Site."""

from sitegen.config.again import read_again
from sitegen.config.jsonschema import json_schema
from sitegen.config.site import load

__all__ = ["json_schema", "load", "read_again"]
