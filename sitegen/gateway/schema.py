"""Define the keys of gateway.yaml as data."""

from __future__ import annotations

from sitegen.config.schema import Key

FILE = (
    Key(
        "origins",
        "list of text",
        "origins of web pages that may connect; `*` matches any text",
        "origins: [https://me.github.io]",
    ),
    Key("allow", "settings", "names that clients may use", "allow: {subscribe: [/odom]}"),
    Key(
        "limits",
        "settings",
        "limits for each client and for all of them",
        "limits: {subscriptions: 20}",
    ),
    Key("keys", "settings", "keys that clients must present", "keys: {secret: gateway.secret}"),
    Key(
        "reservations",
        "settings",
        "calendar that says whose turn it is",
        "reservations: {calendar: lab.ics}",
    ),
    Key(
        "stop",
        "list of text",
        "topics of type Twist that get a final zero when their driver leaves",
        "stop: [/cmd_vel]",
    ),
    Key(
        "people",
        "flag",
        "show pages who else has joined",
        "people: false",
        default=True,
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
        "kind",
        "text",
        "field that names the topic or service, instead of `topic` and `service`",
        "kind: command",
    ),
    Key(
        "topics", "settings", "topics, by their names in rowe", "topics: {speed: {topic: /cmd_vel}}"
    ),
    Key(
        "services",
        "settings",
        "services, by their names in rowe",
        "services: {add-two-numbers: {service: /add_two_ints}}",
    ),
)
ROWE_TOPIC = (
    Key("topic", "text", "its name in ROS", "topic: /cmd_vel", True),
    Key(
        "type",
        "text",
        "its type; needed if no node uses the topic yet",
        "type: geometry_msgs/msg/Twist",
    ),
    Key(
        "fields",
        "mapping of texts",
        "fields of a message and their places in ROS",
        "fields: {v: linear.x}",
    ),
    Key(
        "defaults",
        "data",
        "values, by their places in ROS, that a message need not have",
        "defaults: {linear.x: 0.1}",
    ),
    Key("units", "mapping of texts", "[units](#units) of fields of a message", "units: {v: mm/s}"),
)
ROWE_SERVICE = (
    Key("service", "text", "its name in ROS", "service: /add_two_ints", True),
    Key("type", "text", "its type; needed for `serve`", "type: example_interfaces/srv/AddTwoInts"),
    Key(
        "fields",
        "mapping of texts",
        "fields of a request and their places in ROS",
        "fields: {v: linear.x}",
    ),
    Key(
        "defaults",
        "data",
        "values, by their places in ROS, that a request need not have",
        "defaults: {linear.x: 0.1}",
    ),
    Key("units", "mapping of texts", "[units](#units) of fields of a request", "units: {v: mm/s}"),
    Key(
        "reply",
        "settings",
        "the same for replies: `fields`, `defaults` and `units`",
        "reply: {fields: {answer: sum}}",
    ),
)
ROWE_REPLY = (
    Key(
        "fields",
        "mapping of texts",
        "fields of a reply and their places in ROS",
        "fields: {answer: sum}",
    ),
    Key(
        "defaults",
        "data",
        "values, by their places in ROS, that the reply of a program need not have",
        "defaults: {success: true}",
    ),
    Key("units", "mapping of texts", "[units](#units) of fields of a reply", "units: {v: mm/s}"),
)

ALLOW = (
    Key(
        "subscribe",
        "list of text",
        "topics that clients may subscribe to",
        "subscribe: [/odom, /camera/**]",
    ),
    Key("publish", "list of text", "topics that clients may publish on", "publish: [/cmd_vel]"),
    Key(
        "call_services", "list of text", "services that clients may call", "call_services: [/reset]"
    ),
    Key(
        "advertise_services",
        "list of text",
        "services that clients may offer",
        "advertise_services: [/ask]",
    ),
    Key(
        "send_goals",
        "list of text",
        "actions that clients may send goals to",
        "send_goals: [/navigate]",
    ),
    Key(
        "advertise_actions",
        "list of text",
        "actions that clients may offer",
        "advertise_actions: [/count]",
    ),
    Key(
        "get_parameters",
        "list of text",
        "parameters that clients may read, as `/node:parameter`",
        'get_parameters: ["/**"]',
    ),
    Key(
        "set_parameters",
        "list of text",
        "parameters that clients may set",
        "set_parameters: [/robot:speed]",
    ),
)

LIMITS = (
    Key("connections", "number", "connections in total", "connections: 50", default=200),
    Key(
        "connections_per_address",
        "number",
        "connections from one address",
        "connections_per_address: 5",
        default=50,
    ),
    Key("message_size", "number", "bytes in a message", "message_size: 100000", default=16_000_000),
    Key(
        "messages_per_second",
        "number",
        "messages from one client; it is slowed down to this rate",
        "messages_per_second: 100",
        default=2_000,
    ),
    Key(
        "bytes_per_second",
        "number",
        "bytes from one client; it is slowed down to this rate",
        "bytes_per_second: 1000000",
        default=50_000_000,
    ),
    Key(
        "subscriptions",
        "number",
        "topics that one client subscribes to",
        "subscriptions: 20",
        default=200,
    ),
    Key(
        "publishers", "number", "topics that one client publishes on", "publishers: 5", default=200
    ),
    Key(
        "services",
        "number",
        "services and actions that one client offers, and as many that it calls",
        "services: 5",
        default=100,
    ),
    Key("calls", "number", "unfinished calls and goals of one client", "calls: 10", default=100),
    Key(
        "queue_size",
        "number",
        "bytes waiting for one slow client",
        "queue_size: 4000000",
        default=32_000_000,
    ),
    Key(
        "handshake",
        "number",
        "seconds that a client has to present its key",
        "handshake: 5",
        default=10,
    ),
    Key(
        "stall",
        "number",
        "seconds after which a client that reads nothing is disconnected",
        "stall: 10",
        default=30,
    ),
)

KEYS = (
    Key("secret", "path", "file with the secret that signs keys", "secret: gateway.secret"),
    Key(
        "service",
        "text",
        "address of a service that says how long a key is valid",
        "service: https://lab.example.org/key?key={key}",
    ),
    Key("tries", "number", "wrong keys per minute from one address", "tries: 5", default=10),
)

RESERVATIONS = (
    Key("calendar", "text", "iCalendar file or `https` address", "calendar: lab.ics", True),
    Key("refresh", "number", "seconds after which it is read again", "refresh: 300", default=60),
    Key(
        "watch",
        "flag",
        "let people with a key watch outside their appointments",
        "watch: true",
        default=False,
    ),
)

RECORD = (
    Key("folder", "text", "folder for the recordings", "folder: sessions", True),
    Key(
        "size",
        "number",
        "maximum size of a recording, in bytes",
        "size: 50000000",
        default=1_000_000_000,
    ),
    Key(
        "repository",
        "path",
        "Git repository of the code; its commit is noted in each recording",
        "repository: .",
    ),
    Key("commit", "flag", "commit each recording to `repository`", "commit: true", default=False),
)
