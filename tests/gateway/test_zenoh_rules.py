"""What gateway.yaml allows other gateways."""

from __future__ import annotations

from pathlib import Path

import gateways
from gateways import Gateway, Process, client, free_port, run


def test_rules_hold_for_other_gateways_and_a_robot_stops_when_they_go(
    robot: Process, tmp_path: Path
) -> None:
    port = str(free_port())
    (tmp_path / "gateway.yaml").write_text(
        "allow: {publish: [/cmd_vel], subscribe: [/heard]}\n"
        "stop: [/cmd_vel]\nrecord: {folder: sessions}\n"
    )
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    joining = ["--zenoh", f"localhost:{port}", "--zenoh-port", "0"]

    async def work(here: Gateway) -> None:
        async with client(here) as watching:
            await watching.send(op="subscribe", topic="/heard", type="std_msgs/msg/String")
            with gateways.gateway(*joining, folder=elsewhere, apart=True) as there:
                async with client(there) as driver:
                    topics = (await driver.call("/rosapi/topics"))["values"]["topics"]
                    while "/heard" not in topics:
                        topics = (await driver.call("/rosapi/topics"))["values"]["topics"]
                    assert "/map" not in topics
                    service = await driver.call("/set", {"data": True})
                    assert not service["result"]
                    twist = {"linear": {"x": 0.5}}
                    kind = "geometry_msgs/msg/Twist"
                    await driver.send(op="advertise", topic="/tell", type="std_msgs/msg/String")
                    await driver.send(op="advertise", topic="/cmd_vel", type=kind)
                    await driver.send(op="publish", topic="/cmd_vel", msg=twist)
                    moved = {"data": "drive 0.5 0"}
                    await watching.until("publish", topic="/heard", msg=moved)
                there.process.kill()
                stopped = {"data": "drive 0 0"}
                await watching.until("publish", topic="/heard", msg=stopped)

    with gateways.gateway("--zenoh", "--zenoh-port", port, folder=tmp_path) as running:
        run(work(running))
        assert any(b"/cmd_vel" in file.read_bytes() for file in tmp_path.glob("sessions/*.mcap"))
        assert running.expect("does not allow").endswith("gateway.yaml does not allow /tell")
