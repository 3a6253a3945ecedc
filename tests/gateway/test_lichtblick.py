"""Lichtblick connects to a gateway: what it asks there, by its own packages from npm."""

from __future__ import annotations

import json
import subprocess

from gateways import Gateway
from paths import ROOT, SUPPORT


def test_all_that_lichtblick_asks_is_answered(opened: Gateway) -> None:
    command = ["node", str(SUPPORT / "lichtblick.mjs"), opened.url]
    done = subprocess.run(command, cwd=ROOT, text=True, capture_output=True, timeout=60, check=True)
    assert json.loads(done.stdout.splitlines()[-1]) == {
        "isRos2": True,
        "unread": [],
        "scan": ["Float32Array", "1,NaN,Infinity,2.5"],
        "map": {"data": "the map"},
        "told": "drive 0.5 0.25",
        "called": ["std_srvs/srv/SetBool", {"success": True, "message": "from the robot"}],
        "robot": ["/robot", [True, True, True]],
    }
