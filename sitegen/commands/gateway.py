"""Start the gateway, or say what is missing for it."""

from __future__ import annotations

import argparse
import asyncio
import importlib
import io
import sys
import time
from collections.abc import Callable, Sequence
from contextlib import AsyncExitStack
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from sitegen.errors import SiteError
from sitegen.gateway.addresses import EVERYWHERE, HERE, own_names
from sitegen.report import Report

if TYPE_CHECKING:
    from sitegen.gateway.access import Guard
    from sitegen.gateway.native import Native
    from sitegen.gateway.rules import Rules
    from sitegen.gateway.zenoh import Link

# How often the graph is read at the start (four times in a second).
DISCOVERY = 6


def gateway(arguments: argparse.Namespace, report: Report) -> None:
    """Run the gateway until it is stopped."""
    _need_packages()
    _need_ros()
    joining = _joining(arguments)
    from sitegen.gateway import server
    from sitegen.gateway.config import load
    from sitegen.gateway.log import Log
    from sitegen.gateway.native import Native
    from sitegen.gateway.tls import context

    rules = load(arguments.config)
    files = server.site_files(arguments.site)
    tls = context(arguments.tls, arguments.bind) if arguments.tls else None

    write = Log(report.say).write

    async def run() -> None:
        async with AsyncExitStack() as ending:
            native = Native(domain=arguments.domain)
            await native.start()
            ending.push_async_callback(native.stop)
            await _discover(native)
            await _log(native)
            guard = server.guard(rules, native, write)
            if joining:
                link = await _link(joining, arguments.bind, native, rules, guard, write)
                ending.push_async_callback(link.close)
            shared = server.Gateway(rules, native, server.handlers(), write, files, guard)
            secure = tls.context if tls else None
            await server.run(shared, arguments.bind, arguments.port, tls=secure, ready=ready)

    def ready(port: int) -> None:
        where = addresses(arguments.bind, port)
        alone = arguments.bind in HERE
        told = lines(where, secure=bool(tls), site=bool(arguments.site), alone=alone)
        for line in (*told, *(tls.advice if tls else ())):
            report.say(line.replace("PORT", str(port)))
        if joining and joining.port:
            host = where[-1].rpartition(":")[0]
            report.say(_listening(host, joining.port, alone=alone))
        if arguments.site and not alone:
            report.show(qr_code(f"{'https' if tls else 'http'}://{where[-1]}/"))
        if not alone and rules.allow is None:
            text = "everyone on the network can reach everything on the graph"
            report.say(f"{text}; write 'allow' in gateway.yaml to choose", "warning")

    asyncio.run(run())


class _Joining(NamedTuple):
    """How the graphs of other gateways are joined."""

    addresses: Sequence[str]
    # Where others can connect; 0 for nowhere, or where `config` says.
    port: int
    config: Path | None


def _joining(arguments: argparse.Namespace) -> _Joining | None:
    """Return how the graphs of other gateways are joined, None if they are not."""
    port, config = arguments.zenoh_port, arguments.zenoh_config
    if arguments.zenoh is None:
        for option, given in ("port", port), ("config", config):
            if given is not None:
                raise SiteError([f"--zenoh-{option} has no effect without --zenoh"])
        return None
    for name in ("zenoh", "xxhash"):
        try:
            importlib.import_module(name)
        except ImportError:
            message = f"--zenoh needs {name}, which is not installed"
            raise SiteError([f"{message}: pip install 'ros-sitegen[zenoh]'"]) from None
    from sitegen.gateway.zenoh import PORT

    if config:
        if port is not None:
            message = "--zenoh-port has no effect with --zenoh-config"
            raise SiteError([f"{message}; write listen: {{endpoints: […]}} into {config}"])
        return _Joining(arguments.zenoh, 0, config)
    return _Joining(arguments.zenoh, PORT if port is None else port, None)


async def _link(
    joining: _Joining,
    bind: str,
    native: Native,
    rules: Rules,
    guard: Guard,
    write: Callable[[str], None],
) -> Link:
    """Join the graphs of other gateways."""
    from sitegen.gateway import zenoh

    zenoh.check(rules, native)
    addresses, port, config = joining
    # Listening and the first connections take half a second.
    session = await asyncio.to_thread(zenoh.open_session, addresses, bind, port, config)
    link = zenoh.Link(native, session, rules, guard, write)
    await link.start(len(addresses))
    return link


def _listening(host: str, port: int, *, alone: bool) -> str:
    """Return how other gateways join this one."""
    from sitegen.gateway.zenoh import PORT

    address = host if port == PORT else f"{host}:{port}"
    told = f"for other gateways: sitegen gateway --zenoh {address}"
    return f"{told} (on this computer only)" if alone else told


async def _log(native: Native) -> None:
    """Publish to /rosout, as all nodes do: clients tell by its type that this is ROS 2."""
    from sitegen.gateway.native import Qos, load_type, to_cdr

    kind = load_type("rcl_interfaces/msg/Log")
    qos = Qos(depth=1, transient_local=True)
    publisher = await native.join(None).advertise("/rosout", "rcl_interfaces/msg/Log", qos)
    message = kind(level=20, name=native.name, msg="the gateway of sitegen has started")
    message.stamp.sec, message.stamp.nanosec = divmod(time.time_ns(), 10**9)
    await publisher.publish(to_cdr(message))


async def _discover(native: Native) -> None:
    """Wait until no more endpoints come: the first client would miss them."""
    native.watch(lambda come, gone: None)
    known = -1
    for _ in range(DISCOVERY):
        await asyncio.sleep(0.25)
        await native.refresh()
        if known == (known := len(native.endpoints)) and known:
            return


def addresses(bind: str, port: int) -> list[str]:
    """Return the addresses of a gateway, each with its port; the last one is best for others."""
    if bind in HERE:
        return [f"localhost:{port}"]
    if bind in EVERYWHERE:
        return [f"localhost:{port}", f"{own_names(bind)[-1]}:{port}"]
    return [f"{f'[{bind}]' if ':' in bind else bind}:{port}"]


def lines(where: Sequence[str], *, secure: bool, site: bool, alone: bool) -> list[str]:
    """Return what to tell when the gateway listens at the addresses `where`.

    `alone` says that only this computer reaches it.
    """
    here, *others = where

    def written(scheme: str) -> str:
        scheme += "s" if secure else ""
        more = [f"for others {scheme}://{other}/" for other in others]
        return ", ".join([f"{scheme}://{here}/", *more])

    only = " for this computer only; others: --bind 0.0.0.0" if alone else ""
    told = [f"{written('ws')}{only} (press Ctrl-C to stop)"]
    return [*told, f"the site: {written('http')}"] if site else told


def qr_code(address: str) -> str:
    """Return an address as a QR code of characters, for phones."""
    import segno

    drawn = io.StringIO()
    segno.make_qr(address, error="l").terminal(drawn, border=2, compact=True)
    return drawn.getvalue()


def _need_packages() -> None:
    needed = "aiohttp cbor2 cryptography icalendar mcap recurring_ical_events segno"
    for name in needed.split():
        try:
            importlib.import_module(name)
        except ImportError:
            message = f"the gateway needs {name}, which is not installed"
            raise SiteError([f"{message}: pip install 'ros-sitegen[gateway]'"]) from None


def _need_ros() -> None:
    try:
        importlib.import_module("rclpy")
    except ModuleNotFoundError as error:
        if error.name == "rclpy":
            how = "source its setup.bash in this shell, or: pip install 'ros-rclpy[fastrtps]'"
            raise SiteError([f"the gateway needs ROS 2 beside it: {how}"]) from None
        raise SiteError([_broken(error)]) from None
    except ImportError as error:
        raise SiteError([_broken(error)]) from None


def _broken(error: ImportError) -> str:
    version = ".".join(str(part) for part in sys.version_info[:2])
    why = (str(error).splitlines() or ["it cannot be imported"])[0]
    hint = "install sitegen for the Python that ROS 2 was made for"
    return f"rclpy does not work with this Python {version}: {why}; {hint}"
