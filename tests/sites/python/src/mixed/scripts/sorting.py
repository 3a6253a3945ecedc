#!/usr/bin/env python3
"""A program that uses a package of PyPI, and does without another."""

from sortedcontainers import SortedList

try:
    import nowhere
except ImportError:
    nowhere = None

print(SortedList([3, 1, 2]), nowhere)
