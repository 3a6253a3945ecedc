"""Define the keys of gateway.yaml as data."""

from __future__ import annotations

from sitegen.config.schema import Key

FILE = (
    Key(
        "origins",
        "list of text",
        "web pages of other origins that may connect; `*` stands for anything",
        "origins: [https://me.github.io]",
    ),
    Key("allow", "settings", "names that clients may use", "allow: {subscribe: [/odom]}"),
    Key("limits", "settings", "what a client may take", "limits: {subscriptions: 20}"),
    Key("keys", "settings", "keys that clients need", "keys: {secret: gateway.secret}"),
    Key(
        "reservations",
        "settings",
        "whose turn it is, from a calendar",
        "reservations: {calendar: lab.ics}",
    ),
    Key(
        "stop",
        "list of text",
        "topics of type Twist that get a last zero when the client that drove leaves",
        "stop: [/cmd_vel]",
    ),
    Key("record", "settings", "record each session to an MCAP file", "record: {folder: sessions}"),
    Key(
        "rowe",
        "settings",
        "names for programs without ROS",
        "rowe: {services: {add-two-numbers: {service: /add_two_ints}}}",
    ),
)

ROWE = (
    Key(
        "topics", "settings", "topics by their names in rowe", "topics: {speed: {topic: /cmd_vel}}"
    ),
    Key(
        "services",
        "settings",
        "services by their names in rowe",
        "services: {add-two-numbers: {service: /add_two_ints}}",
    ),
)
ROWE_TOPIC = (
    Key("topic", "text", "the name in ROS", "topic: /cmd_vel", True),
    Key("type", "text", "its type, if nobody else has it", "type: geometry_msgs/msg/Twist"),
)
ROWE_SERVICE = (
    Key("service", "text", "the name in ROS", "service: /add_two_ints", True),
    Key("type", "text", "its type, for `serve`", "type: example_interfaces/srv/AddTwoInts"),
)

ALLOW = (
    Key("subscribe", "list of text", "topics to clients", "subscribe: [/odom, /camera/**]"),
    Key("publish", "list of text", "topics from clients", "publish: [/cmd_vel]"),
    Key("call_services", "list of text", "services of the robot", "call_services: [/reset]"),
    Key("advertise_services", "list of text", "services of clients", "advertise_services: [/ask]"),
    Key("send_goals", "list of text", "actions of the robot", "send_goals: [/navigate]"),
    Key("advertise_actions", "list of text", "actions of clients", "advertise_actions: [/count]"),
    Key(
        "get_parameters",
        "list of text",
        "parameters that clients read, as `/node:parameter`",
        'get_parameters: ["/**"]',
    ),
    Key(
        "set_parameters",
        "list of text",
        "parameters that clients set",
        "set_parameters: [/robot:speed]",
    ),
)

LIMITS = (
    Key("connections", "number", "connections in all", "connections: 50", default=200),
    Key(
        "connections_per_address",
        "number",
        "connections from one address",
        "connections_per_address: 5",
        default=50,
    ),
    Key("message_size", "number", "bytes of a message", "message_size: 100000", default=16_000_000),
    Key(
        "messages_per_second",
        "number",
        "messages from a client; more have to wait",
        "messages_per_second: 100",
        default=2_000,
    ),
    Key(
        "bytes_per_second",
        "number",
        "bytes from a client; more have to wait",
        "bytes_per_second: 1000000",
        default=50_000_000,
    ),
    Key("subscriptions", "number", "topics that a client hears", "subscriptions: 20", default=200),
    Key("publishers", "number", "topics that a client publishes", "publishers: 5", default=200),
    Key("services", "number", "services and actions of a client", "services: 5", default=100),
    Key("calls", "number", "calls and goals at once", "calls: 10", default=100),
    Key(
        "queue_size",
        "number",
        "bytes that wait for a slow client",
        "queue_size: 4000000",
        default=32_000_000,
    ),
    Key("handshake", "number", "seconds until the key", "handshake: 5", default=10),
    Key("stall", "number", "seconds in which a client reads nothing", "stall: 10", default=30),
)

KEYS = (
    Key("secret", "path", "file with the secret that signs keys", "secret: gateway.secret"),
    Key(
        "service",
        "text",
        "address that says for how long a key is good",
        "service: https://lab.example.org/key?key={key}",
    ),
    Key("tries", "number", "wrong keys from one address in a minute", "tries: 5", default=10),
)

RESERVATIONS = (
    Key("calendar", "text", "iCalendar file or `https` address", "calendar: lab.ics", True),
    Key("refresh", "number", "seconds until it is read again", "refresh: 300", default=60),
    Key(
        "watch",
        "flag",
        "let persons with a key watch outside of their appointments",
        "watch: true",
        default=False,
    ),
)

RECORD = (
    Key("folder", "text", "folder for the recordings", "folder: sessions", True),
    Key(
        "size", "number", "bytes of the largest recording", "size: 50000000", default=1_000_000_000
    ),
    Key("repository", "path", "Git repository with the code used", "repository: ."),
    Key("commit", "flag", "commit each recording to it", "commit: true", default=False),
)
