"""The graphs of two gateways, joined over Zenoh, with a native robot behind the first."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import gateways
import pytest
import zenoh
from cryptography import x509
from cryptography.hazmat.primitives import hashes
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.hazmat.primitives.serialization import Encoding, NoEncryption, PrivateFormat
from cryptography.x509.oid import NameOID
from gateways import Gateway, Process, client, free_port, run
from native import HERE, Native, own_domain
from waiting import until

# The end of a token: the type of a topic or service, its hash, and the quality of service.
STRING = "std_msgs::msg::dds_::String_"
DEFAULT = "::,10:,:,:,,"


def refused(*options: str | Path, folder: Path) -> str:
    """Return why a gateway does not start."""
    native = Native()
    command = [native.python, "-m", "sitegen", "gateway", "--port", "0", *options]
    environment = gateways.environment(native, apart=True)
    done = subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 1, done.stdout
    why, _, rest = done.stderr.strip().rpartition("\n")
    assert rest == "1 problem"
    return why


def connecting(address: str) -> zenoh.Config:
    settings = zenoh.Config()
    settings.insert_json5("scouting/multicast/enabled", "false")
    settings.insert_json5("connect/endpoints", json.dumps([address]))
    return settings


def joined(port: int) -> zenoh.Session:
    """Return a session of Zenoh that has joined a gateway."""
    return zenoh.open(connecting(f"tcp/localhost:{port}"))


def write(file: Path, content: dict[str, object]) -> None:
    file.write_text(json.dumps(content))


def certificate(folder: Path) -> None:
    """Make a certificate for localhost, its key, and the authority that has signed it."""

    def name(common: str) -> x509.Name:
        return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, common)])

    now = datetime.now(UTC)
    authority, key = (ec.generate_private_key(ec.SECP256R1()) for _ in range(2))
    for subject, own, file in (
        ("authority", authority, "authority"),
        ("localhost", key, "listen_certificate"),
    ):
        signed = (
            x509.CertificateBuilder(name("authority"), name(subject), own.public_key())
            .serial_number(x509.random_serial_number())
            .not_valid_before(now - timedelta(hours=1))
            .not_valid_after(now + timedelta(days=1))
            .add_extension(x509.BasicConstraints(own is authority, None), critical=True)
            .add_extension(x509.SubjectAlternativeName([x509.DNSName(subject)]), critical=False)
            .sign(authority, hashes.SHA256())
        )
        (folder / f"{file}.pem").write_bytes(signed.public_bytes(Encoding.PEM))
    plain = key.private_bytes(Encoding.PEM, PrivateFormat.PKCS8, NoEncryption())
    (folder / "listen_private_key.pem").write_bytes(plain)


@pytest.fixture(scope="module")
def port() -> int:
    """Where the first gateway listens for others."""
    return free_port()


@pytest.fixture(scope="module")
def here(robot: Process, port: int, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Gateway]:
    """The gateway of the robot."""
    folder = tmp_path_factory.mktemp("here")
    with gateways.gateway("--zenoh", "--zenoh-port", str(port), folder=folder) as running:
        yield running


@pytest.fixture
def options(here: Gateway, port: int) -> list[str]:
    """How another gateway joins it."""
    return ["--zenoh", f"localhost:{port}", "--zenoh-port", "0"]


def visit() -> Process:
    """Run a node apart from the robot."""
    native = Native()
    environment = gateways.environment(native, apart=True)
    return Process(native.python, HERE / "visitor.py", env=environment)


def test_a_native_node_uses_a_robot_of_another_graph(
    options: list[str], here: Gateway, tmp_path: Path
) -> None:
    with gateways.gateway(*options, folder=tmp_path, apart=True) as there:
        visitor = visit()
        try:
            told: dict[str, Any] = json.loads(visitor.expect("{"))
        finally:
            visitor.stop()
        # One of each: nothing that a gateway tells comes back to it.
        nodes = [name for name in told.pop("nodes") if "sitegen" not in name]
        assert nodes == ["robot", "visitor"]
        assert told.pop("heard") == [str(number) for number in range(300)]
        assert told == {
            "publishers": {"/heard": 1, "/map": 1, "/protected_door": 0},
            "maps": ["the map"],
            "set": "from the robot",
            "result": [0, 1, 1, 2, 3],
            "feedback": [[0, 1, 1], [0, 1, 1, 2], [0, 1, 1, 2, 3]],
            "speed": 1.5,
        }
        assert "zenoh: connected to router" in "\n".join(there.lines)
        start = len(here.lines)
    here.expect(": left", start)


def test_clients_of_one_gateway_use_the_robot_of_another(
    options: list[str], tmp_path: Path
) -> None:
    async def work() -> None:
        async with client(there) as page:
            await page.settle()
            await page.send(op="subscribe", topic="/map", type="std_msgs/msg/String")
            assert (await page.until("publish", topic="/map"))["msg"] == {"data": "the map"}
            assert (await page.call("/set", {"data": True}))["values"]["message"] == (
                "from the robot"
            )
            await page.send(op="advertise_service", service="/of_client", type="std_srvs/Trigger")
            await page.send(op="call_service", service="/call_back", id="back")
            asked = await page.until("call_service", service="/of_client")
            values = {"success": True, "message": "from a client"}
            answer = {"service": "/of_client", "id": asked["id"], "result": True}
            await page.send(op="service_response", values=values, **answer)
            assert (await page.until("service_response", id="back"))["values"] == values

    with gateways.gateway(*options, folder=tmp_path, apart=True) as there:
        run(work())


def nodes(running: Gateway) -> list[str]:
    async def work() -> list[str]:
        async with client(running) as page:
            found: list[str] = (await page.call("/rosapi/nodes"))["values"]["nodes"]
            return found

    return run(work())


def test_a_gateway_that_is_killed_leaves_no_ghosts_and_comes_back(
    options: list[str], here: Gateway, tmp_path: Path
) -> None:
    visitor = visit()
    try:
        for _ in range(2):
            with gateways.gateway(*options, folder=tmp_path, apart=True) as there:
                until(lambda: nodes(here).count("/visitor") == 1, told=lambda: str(nodes(here)))
                start = len(here.lines)
                there.process.kill()
                here.expect(": left", start)
            until(lambda: "/visitor" not in nodes(here), told=lambda: str(nodes(here)))
    finally:
        visitor.stop()


def use_the_robot(port: int, listening: Gateway) -> None:
    """Run a client of rmw_zenoh that others have written; it connects at `port`."""
    native = Native()
    environment = gateways.environment(native, apart=True)
    domain = environment["ROS_DOMAIN_ID"]
    command: list[str | Path] = [native.python, HERE / "sdk.py", str(port), domain]
    with subprocess.Popen(
        command, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as sdk:
        try:
            assert sdk.stdout
            told = json.loads(sdk.stdout.readline())
            assert told == {"heard": [str(n) for n in range(90)], "set": "from the robot"}
            assert "/sdk" in nodes(listening)

            async def work() -> None:
                async with client(listening) as page:
                    answer = await page.call("/of_sdk", {"data": True})
                    assert answer["values"] == {"success": True, "message": "from the sdk"}

            run(work())
        finally:
            sdk.kill()


def test_a_client_of_rmw_zenoh_that_others_have_written(here: Gateway, port: int) -> None:
    use_the_robot(port, here)


def test_a_gateway_passes_on_what_is_for_another(here: Gateway, port: int, tmp_path: Path) -> None:
    between = gateways.free_port()
    options = ["--zenoh", f"localhost:{port}", "--zenoh-port", str(between)]
    with gateways.gateway(*options, folder=tmp_path, apart=True):
        use_the_robot(between, here)


def test_the_connection_is_encrypted_as_a_file_says(tmp_path: Path) -> None:
    secure = gateways.free_port()
    certificate(tmp_path)
    listening = {"endpoints": [f"tls/localhost:{secure}"]}
    tls = {
        name: str(tmp_path / f"{name}.pem") for name in ("listen_certificate", "listen_private_key")
    }
    write(tmp_path / "listens.json5", {"listen": listening, "transport": {"link": {"tls": tls}}})
    trusted = {"root_ca_certificate": str(tmp_path / "authority.pem")}
    write(tmp_path / "connects.json5", {"transport": {"link": {"tls": trusted}}})
    address = ["--zenoh", f"tls/localhost:{secure}", "--zenoh-config", "connects.json5"]
    # In a domain of their own, in which nobody else has joined.
    with (
        own_domain(),
        gateways.gateway("--zenoh", "--zenoh-config", "listens.json5", folder=tmp_path) as near,
        gateways.gateway(*address, folder=tmp_path, apart=True),
    ):
        near.expect("zenoh: connected to router")
        # Nothing listens besides.
        with zenoh.open(connecting(f"tcp/localhost:{secure}")) as plain:
            assert plain.info.transports() == []


def test_definitions_that_differ_are_told_with_both_hashes(here: Gateway, port: int) -> None:
    domain = Native().environment["ROS_DOMAIN_ID"]
    with joined(port) as session:
        endpoint = f"@ros2_lv/{domain}/{session.zid()}/1/2/MP/%/%/other/%differs"
        key = f"{endpoint}/{STRING}/RIHS01_0/{DEFAULT}"
        with session.liveliness().declare_token(key):
            line = here.expect("differs between")
    assert (
        "/differs: 'std_msgs/msg/String' differs between the two gateways: RIHS01_0 there" in line
    )
    assert "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18 here" in line


@pytest.mark.parametrize(
    "rest",
    [
        "1/2/XX/%/%/node",
        "1/2/NN/%/%/no-de",
        "1/x/NN/%/%/node",
        "1/2/MP/%/%/node",
        f"1/2/NN/%/%/node/%topic/{STRING}/RIHS01_0/{DEFAULT}",
        f"1/2/MP/%/%/node/%to pic/{STRING}/RIHS01_0/{DEFAULT}",
        f"1/2/MP/%/%/node/%{'long' * 100}/{STRING}/RIHS01_0/{DEFAULT}",
        f"1/2/MP/%/%/node/%topic/os.path/RIHS01_0/{DEFAULT}",
        f"1/2/MP/%/%/node/%topic/{STRING}/RIHS01_0/::,x:,:,:,,",
        f"1/2/MP/%/%/node/%topic/{STRING}/RIHS01_0/::,{'9' * 5000}:,:,:,,",
        f"1/2/MP/%/%/node/%topic/{STRING}/RIHS01_0/:::",
    ],
)
def test_invalid_tokens_are_no_part_of_the_graph(here: Gateway, port: int, rest: str) -> None:
    domain = Native().environment["ROS_DOMAIN_ID"]
    with joined(port) as session:
        start = f"@ros2_lv/{domain}/{session.zid()}"
        tokens = (f"{start}/{rest}", f"{start}/3/3/NN/%/%robots/valid")
        # They go with their objects.
        kept = [session.liveliness().declare_token(key) for key in tokens]
        until(lambda: "/robots/valid" in nodes(here), told=lambda: "\n".join(here.lines))
        assert not {"/node", "/no-de"} & set(nodes(here))
        assert len(kept) == 2
    until(lambda: "/robots/valid" not in nodes(here))


def test_of_two_gateways_of_one_graph_the_second_does_not_join(
    options: list[str], here: Gateway, tmp_path: Path
) -> None:
    native = Native()
    command: list[str | Path] = [native.python, "-m", "sitegen", "gateway", "--port", "0"]
    second = Process(*command, *options, env=gateways.environment(native), cwd=tmp_path)
    try:
        # At once, or as soon as it has found the other one.
        second.expect("another gateway has joined this graph already")
    finally:
        second.stop()
    assert "/robot" in nodes(here)


def test_what_cannot_work_is_said_in_a_line(here: Gateway, port: int, tmp_path: Path) -> None:
    def error(*options: str | Path) -> str:
        return refused(*options, folder=tmp_path)

    used = error("--zenoh", "--zenoh-port", str(port))
    assert used == (
        f"--zenoh: port {port} is in use, perhaps by a router of Zenoh; "
        "to join that one: --zenoh localhost --zenoh-port 0"
    )
    wrong = "--zenoh: 'robot:99999' is not an address; write it like robot:7447"
    assert error("--zenoh", "robot:99999") == wrong
    assert error("--zenoh", "--zenoh-port", "-4") == "--zenoh-port: -4 is not a port"
    twice = error("--zenoh", "--zenoh-port", "7447", "--zenoh-config", "zenoh.json5")
    assert twice.startswith("--zenoh-port has no effect with --zenoh-config")
    assert error("--zenoh-port", "7447") == "--zenoh-port has no effect without --zenoh"
    (tmp_path / "zenoh.json5").write_text("{listn: 3}")
    unknown = "--zenoh-config: zenoh.json5: unknown field `listn`"
    assert error("--zenoh", "--zenoh-config", "zenoh.json5") == unknown
    (tmp_path / "gateway.yaml").write_text("keys: {secret: gateway.secret}\n")
    (tmp_path / "gateway.secret").write_text("secret" * 10)
    (tmp_path / "gateway.secret").chmod(0o600)
    assert error("--zenoh").startswith("--zenoh: gateway.yaml asks clients for keys")
