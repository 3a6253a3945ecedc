"""Take part in the native ROS 2 graph from an asyncio program; only this package imports rclpy.

    native = Native()
    await native.start()
    stop = native.watch(lambda come, gone: …)  # Endpoints of the graph, now and as they change
    party = native.join("page 7")
    await party.add_node("/talker")
    publisher = await party.advertise("/chatter", "std_msgs/msg/String", Qos(), node="/talker")
    await publisher.publish(cdr)
    subscription = await party.subscribe("/chatter", "std_msgs/msg/String", Qos(), received)
    client = await party.client("/add", "example_interfaces/srv/AddTwoInts", node="/talker")
    response = await client.call(cdr)
    server = await party.serve("/set", "std_srvs/srv/SetBool", asked, node="/talker")
    await subscription.close()
    await party.close()  # everything of this party leaves the graph
    await native.stop()

Everything is called in the thread of the event loop, and callbacks are called in it. Messages are
bytes: CDR with its head of four bytes. `load_type`, `to_cdr` and `from_cdr` change them into
rclpy's messages and back. ROS itself runs in one thread (`spin.py`), which takes no more messages
while the event loop is behind: the middleware then keeps the newest, as the quality of service
says. A burst arrives whole only if the subscription's depth allows for it.
"""

from sitegen.gateway.native.descriptions import describe, hash_of
from sitegen.gateway.native.endpoint import (
    Endpoint,
    Kind,
    MalformedMessageError,
    NativeError,
    Qos,
    Sample,
    UnknownTypeError,
)
from sitegen.gateway.native.native import Native
from sitegen.gateway.native.party import Party
from sitegen.gateway.native.services import Client, Request, Server
from sitegen.gateway.native.topics import Publisher, Subscription
from sitegen.gateway.native.types import definition, from_cdr, installed, load_type, to_cdr

__all__ = [
    "Client",
    "Endpoint",
    "Kind",
    "MalformedMessageError",
    "Native",
    "NativeError",
    "Party",
    "Publisher",
    "Qos",
    "Request",
    "Sample",
    "Server",
    "Subscription",
    "UnknownTypeError",
    "definition",
    "describe",
    "from_cdr",
    "hash_of",
    "installed",
    "load_type",
    "to_cdr",
]
