"""Turn measurements into a table and a file: `python -m bench [PART ...]`, all parts by default."""

from __future__ import annotations

import argparse
import datetime
import json
import os
import platform
import sys
import time
import traceback
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path

from bench import building, crowd, messages, pages, plots, prose, python
from bench.counts import FULL, SMALLEST, Counts
from bench.figure import Figure, table

PARTS: dict[str, Callable[[Counts], list[Figure]]] = {
    "latency": messages.latency,
    "throughput": messages.throughput,
    "services": messages.services,
    "fan": crowd.fan,
    "flood": crowd.flood,
    "idle": crowd.idle,
    "many": crowd.many,
    "plots": plots.plots,
    "start": pages.start,
    "python": python.python,
    "size": pages.size,
    "build": building.build,
    "prose": prose.prose,
}
RESULTS = Path(__file__).parent / "results"


def main(argv: Sequence[str] | None = None) -> int:
    """Measure the parts that `argv` names; return how many failed."""
    parser = argparse.ArgumentParser("bench", description="Measure the speed of sitegen.")
    parser.add_argument("part", nargs="*", choices=[[], *PARTS], help=", ".join(PARTS))
    parser.add_argument(
        "--smallest", action="store_true", help="check that parts run; the figures mean nothing"
    )
    arguments = parser.parse_args(argv)
    counts = SMALLEST if arguments.smallest else FULL

    load = os.getloadavg()[0]
    if load > 0.5:
        print(f"the machine is busy (load {load:.1f}): take the figures as upper bounds")
    file = RESULTS / f"{datetime.datetime.now():%Y-%m-%d-%H%M%S}.json"
    figures: list[Figure] = []
    failed = []
    for part in arguments.part or PARTS:
        print(f"{part} …", file=sys.stderr)
        begun = time.monotonic()
        try:
            found = PARTS[part](counts)
        except Exception:
            # The other parts do not depend on it, and some took minutes.
            traceback.print_exc()
            failed.append(part)
            continue
        print(f"{part}: {time.monotonic() - begun:.0f} s", file=sys.stderr)
        print(table(found), flush=True)
        figures += found
        save(figures, counts, load, file)
    if figures:
        print(f"\n{table(figures)}\n→ {file.relative_to(RESULTS.parents[1])}")
    if failed:
        print(f"failed: {', '.join(failed)}", file=sys.stderr)
    return len(failed)


def save(figures: Sequence[Figure], counts: Counts, load: float, file: Path) -> None:
    """Write the figures so far to `file`, with their counts and the machine."""
    machine = {"processor": platform.processor() or platform.machine(), "cores": os.cpu_count()}
    result = {
        "date": datetime.datetime.now().isoformat(timespec="seconds"),
        "machine": machine | {"load": load},
        "counts": asdict(counts),
        "figures": [figure.entry() for figure in figures],
    }
    file.parent.mkdir(exist_ok=True)
    file.write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    sys.exit(main())
