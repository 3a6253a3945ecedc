"""Two gateways in two networks, of which one is cut off for a while."""

from __future__ import annotations

import time
from contextlib import ExitStack
from pathlib import Path

import gateways
from gateways import Process
from native import HERE, Native
from networks import Network, networks, only_root
from waiting import until

# How many messages are sent while the network is cut, and how often (s).
CUT, PERIOD = 40, 0.05


@only_root
def test_nothing_is_lost_when_the_network_is_cut_for_a_while(tmp_path: Path) -> None:
    native = Native()
    gateway = ["-m", "sitegen", "gateway", "--port", "0", "--zenoh"]
    with networks() as (first, second), ExitStack() as stack:

        def start(network: Network, *command: str | Path, expect: str = "") -> Process:
            # So that DDS does not join the two by itself, with multicast.
            env = gateways.environment(native, apart=network is second)
            running = Process(*network.inside, native.python, *command, env=env, cwd=tmp_path)
            stack.callback(running.stop)
            if expect:
                running.expect(expect)
            return running

        start(first, HERE / "robot.py", expect="ready")
        here = start(first, *gateway, "--bind", first.address, expect="for other gateways")
        start(second, *gateway, first.address, "--zenoh-port", "0", expect="ws:")
        talk = start(second, HERE / "talk.py")
        say = talk.say
        number = 0

        def answered() -> bool:
            say("settled")
            return "settled" in talk.lines

        until(answered)
        first.set("down")
        for number in range(CUT):
            say(str(number))
            time.sleep(PERIOD)
        assert "0" not in talk.lines
        first.set("up")
        talk.expect(str(CUT - 1))
        heard = [line for line in talk.lines if line != "settled"]
        assert heard == [str(number) for number in range(CUT)]
        assert "left" not in "\n".join(here.lines)
