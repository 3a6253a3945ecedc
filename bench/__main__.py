"""Turn measurements into a table and a file: `python -m bench [PART ...]`, all parts by default."""

from __future__ import annotations

import argparse
import datetime
import json
import os
import platform
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from bench import building, crowd, messages, pages, prose, python
from bench.figure import Figure, table

PARTS: dict[str, Callable[[], list[Figure]]] = {
    "latency": messages.latency,
    "throughput": messages.throughput,
    "services": messages.services,
    "fan": crowd.fan,
    "flood": crowd.flood,
    "idle": crowd.idle,
    "many": crowd.many,
    "start": pages.start,
    "python": python.python,
    "size": pages.size,
    "build": building.build,
    "prose": prose.prose,
}
RESULTS = Path(__file__).parent / "results"


def main(argv: Sequence[str] | None = None) -> None:
    """Measure the parts that `argv` names."""
    parser = argparse.ArgumentParser("bench", description="Measure the speed of sitegen.")
    parser.add_argument("part", nargs="*", choices=[[], *PARTS], help=", ".join(PARTS))
    wanted = parser.parse_args(argv).part or list(PARTS)

    load = os.getloadavg()[0]
    if load > 0.5:
        print(f"the machine is busy (load {load:.1f}): take the figures as upper bounds")
    figures = []
    for part in wanted:
        print(f"{part} …", file=sys.stderr)
        begun = time.monotonic()
        figures += PARTS[part]()
        print(f"{part}: {time.monotonic() - begun:.0f} s", file=sys.stderr)
    print(table(figures))
    print(f"→ {save(figures, load)}")


def save(figures: Sequence[Figure], load: float) -> Path:
    """Keep the figures, and where they were measured."""
    now = datetime.datetime.now()
    machine = {"processor": platform.processor() or platform.machine(), "cores": os.cpu_count()}
    result = {
        "date": now.isoformat(timespec="seconds"),
        "machine": machine | {"load": load},
        "figures": [figure.entry() for figure in figures],
    }
    RESULTS.mkdir(exist_ok=True)
    file = RESULTS / f"{now:%Y-%m-%d-%H%M%S}.json"
    file.write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n")
    return file.relative_to(Path.cwd()) if file.is_relative_to(Path.cwd()) else file


if __name__ == "__main__":
    main()
