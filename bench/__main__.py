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

from bench import (
    bags,
    building,
    crowd,
    gateway,
    large_bag,
    messages,
    notebooks,
    pages,
    plots,
    prose,
    python,
    rowe,
    scene,
    scripts,
    terminals,
    zenoh_gateways,
)
from bench.counts import FULL, SMALLEST, Counts
from bench.figure import Figure, table
from bench.kept import changes, keep, load_kept, median

PARTS: dict[str, Callable[[Counts], list[Figure]]] = {
    "latency": messages.latency,
    "throughput": messages.throughput,
    "services": messages.services,
    "fan": crowd.fan,
    "flood": crowd.flood,
    "idle": crowd.idle,
    "many": crowd.many,
    "plots": plots.plots,
    "bags": bags.bags,
    "large-bag": large_bag.large_bag,
    "scene": scene.scene,
    "start": pages.start,
    "scripts": scripts.scripts,
    "terminal": terminals.terminals,
    "python": python.python,
    "notebooks": notebooks.notebooks,
    "gateway": gateway.gateway,
    "zenoh": zenoh_gateways.zenoh,
    "rowe": rowe.rowe,
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
    parser.add_argument(
        "--runs", type=int, default=1, metavar="N", help="measure each part N times: the medians"
    )
    parser.add_argument(
        "--keep", action="store_true", help="compare later runs with this one (kept.json)"
    )
    arguments = parser.parse_args(argv)
    if arguments.runs < 1:
        parser.error("--runs: at least 1")
    if arguments.keep and arguments.smallest:
        parser.error("--keep: the figures of --smallest mean nothing")
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
            found = median([PARTS[part](counts) for _ in range(arguments.runs)])
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
        kept = {} if arguments.smallest else load_kept()
        print(f"\n{table(figures, kept)}\n→ {file.relative_to(RESULTS.parents[1])}")
        for line in changes(figures, kept):
            print(f"worse: {line}")
    if arguments.keep:
        keep(figures)
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
