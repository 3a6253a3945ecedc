"""Filters and the files of the terminal's shell, with the shell itself, in Node."""

from __future__ import annotations

from shellnode import shell

PRINTED = [
    ("echo 'b 2' > f; echo 'a 10' >> f; echo 'b 2' >> f; sort f", "a 10\nb 2\nb 2\n"),
    ("sort -u f | wc -l", "2\n"),
    ("sort -r f | uniq -c", "      2 b 2\n      1 a 10\n"),
    ("sort f | uniq -d; sort f | uniq -u", "b 2\na 10\n"),
    ("echo 10 > n; echo 9 >> n; sort -n n; sort n", "9\n10\n10\n9\n"),
    ("cat f | tee g h | wc -l; wc -l g h", "3\n6\n"),
    ("sort nothing", "sort: nothing: No such file or directory\n"),
    # Where no keys come, less prints all.
    ("less f | head -1", "b 2\n"),
    ("printenv ROS_VERSION; pwd; env | grep -c ROS", "2\n/\n2\n"),
    # A name that all objects have is no variable.
    ("echo [$__proto__$constructor]", "[]\n"),
    ("bg %1", "bg: %1: no such job\n"),
]


def test_filters_sort_count_and_copy() -> None:
    found = shell([line for line, _ in PRINTED])
    for (line, expected), (shown, _) in zip(PRINTED, found, strict=True):
        assert shown == expected, line
