"""Measure rowe in three languages beside an echo of the package websockets alone."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from bench.counts import Counts
from bench.figure import Figure, Target

ROOT = Path(__file__).parent.parent
PROGRAMS = Path(__file__).parent / "rowe_programs"
SOURCES = ROOT / "sitegen" / "clients" / "rowe" / "c"
LIBRARIES = ("-lwebsockets", "-ljson-c", "-lpthread", "-lm")
# Delays may be 1.3 times those of the bare echo, and rates must be as near to it.
MOST = 1.3


def rowe(counts: Counts) -> list[Figure]:
    """The round trip of `invoke` and the throughput of `async_send`, each language with itself."""
    turns = 250 * counts.turns
    figures = []
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program"
        sources = [*sorted(SOURCES.glob("*.c")), PROGRAMS / "program.c"]
        compiler = ["gcc", "-O2", f"-I{SOURCES}", "-o", str(program)]
        subprocess.run([*compiler, *map(str, sources), *LIBRARIES], check=True)
        commands = {
            "Python": [sys.executable, str(PROGRAMS / "program.py")],
            "JavaScript": ["node", str(PROGRAMS / "program.mjs")],
            "C": [str(program)],
        }
        bare_delay, bare_rate = _measured([sys.executable, str(PROGRAMS / "bare.py")], turns)
        for language, command in commands.items():
            delay, rate = _measured(command, turns)
            least = Target("ratio", "≥", 1 / MOST)
            most = Target("ratio", "≤", MOST)
            figures += [
                Figure(f"rowe, round trip of invoke, {language}", "ms", delay, bare_delay, most),
                Figure(f"rowe, async_send, {language}", "/s", rate, bare_rate, least),
            ]
    return figures


def _measured(command: list[str], turns: int) -> tuple[float, float]:
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(
        [*command, "serve"], cwd=ROOT, env=env, stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout
        try:
            port = server.stdout.readline().strip()
            play = [*command, "play", port, str(turns)]
            found = subprocess.run(
                play, cwd=ROOT, env=env, stdout=subprocess.PIPE, text=True, check=True, timeout=300
            )
        finally:
            server.kill()
    delay, rate = json.loads(found.stdout)
    return delay, rate
