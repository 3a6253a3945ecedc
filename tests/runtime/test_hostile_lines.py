"""Ten thousand mutated command lines: each ends with a status and a text, and none with a bug."""

from __future__ import annotations

import re
from random import Random

from shellnode import shell

COUNT = 10_000
# Seconds after which Ctrl-C ends what goes on, such as `ros2 topic echo`.
WAIT = 0.015
SEEDS = [
    *("ros2 node list -a", "ros2 node info /talker", "ros2 topic list -t -v", "ros2 topic type /x"),
    *("ros2 topic echo /chatter --once", "ros2 topic echo /points --field point.x --csv -l 3"),
    "ros2 topic echo /points --filter \"m.point.x > 1 and 'map' in m.header.frame_id\"",
    *("ros2 topic hz /chatter /points --window 3", "ros2 topic bw /chatter", "ros2 topic delay /p"),
    "ros2 topic pub -r 100 -t 2 -w 0 /said std_msgs/msg/String '{data: \"hi\"}'",
    "ros2 topic pub -1 -w 0 /new geometry_msgs/msg/PointStamped '{header: auto, point: {x: 1.5}}'",
    *("ros2 topic find std_msgs/msg/String", "ros2 topic info /chatter -v", "ros2 service list -t"),
    "ros2 service call /mute std_srvs/srv/SetBool '{data: true}' -r 2",
    *("ros2 service type /mute", "ros2 service info -v /mute", "ros2 service echo /mute"),
    "ros2 action send_goal /fibonacci test_msgs/action/Fibonacci '{order: 3}' -f -t 1",
    *("ros2 action info /fibonacci -t", "ros2 param set /talker volume 3 --timeout 0"),
    *(
        "ros2 param list /talker --filter vol",
        "ros2 param dump /talker",
        "ros2 param load /talker f",
    ),
    *("ros2 interface show geometry_msgs/msg/Twist", "ros2 interface proto std_msgs/msg/String"),
    *(
        "ros2 interface list -m",
        "ros2 lifecycle set /talker activate",
        "ros2 lifecycle get /talker",
    ),
    *("ros2 component load /box p p::C -r a:=b", "ros2 component unload /box 1", "ros2 doctor -r"),
    *("ros2 run speaking talker --ros-args -r a:=b -p c:=1", "ros2 launch p f.launch.py x:=1"),
    *("ros2 pkg executables speaking", "ros2 daemon status", "ros2 bag info talk", "ros2 wtf"),
    "ros2 bag play talk -r 2 -l --topics /a --remap /a:=/b --clock 10",
    *("echo a 'b c' \"$?\" > f; cat f | grep -n b | wc -l", "cat < f && false || echo $HOME # x"),
    *("head -2 f; tail -n 1 f; sort -r f | uniq -c", "sleep 0.001 & jobs; kill %1; wait; history"),
]
SIGNS = r"""
' " \ $ $( ` | || & && ; > >> < 2>&1 # ( ) -- - -h é 💥 [ ] { } {{ , * / // a/b/c/d ((((( [[[[[
999999999999999999999 -1 1e400 nan .inf null ~ !!python/object ../../etc/passwd __proto__
constructor toString --field --filter 0x41 %s%n __class__ m.__dict__
"""
ODD = [*SIGNS.split(), "\0", "\x1b[2J", "\u202e", ": ", "&a *a", "\t", "\n", "a" * 300]
# What JavaScript says of a bug, and terminals obey.
BUG = re.compile(
    r"TypeError: (?!Value|'|int|float)|is not a function|Cannot read|(?<!' )is not defined|"
    r"undefined|\[object |Maximum call|Invalid array|(?<!object )is not iterable|"
    r"Cannot (?:mix|convert)|out of memory|RangeError|ReferenceError|NaN\b"
)
STATUSES = {0, 1, 2, 127, 130, 141}


def mutated(random: Random) -> str:
    """A line of the seeds, in which pieces are removed, inserted, repeated and exchanged."""
    line = random.choice(SEEDS)
    for _ in range(random.choice([1, 1, 1, 2, 3, 5])):
        # Most names of commands and verbs stay, so that the others see what follows.
        least = 0 if random.random() < 0.2 else len(" ".join(line.split(" ")[:3]))
        at = random.randint(min(least, len(line)), len(line))
        end = min(len(line), at + random.randint(0, 8))
        chance = random.random()
        if chance < 0.25:
            line = line[:at] + line[end:]
        elif chance < 0.7:
            line = line[:at] + random.choice(ODD) + line[at:]
        elif chance < 0.8:
            line = line[:end] + line[at:]
        else:
            words = line.split(" ")
            words.insert(random.randint(min(3, len(words)), len(words)), random.choice(ODD))
            line = " ".join(words)
    return line


def test_mutated_lines_end_with_a_status_and_a_text() -> None:
    random = Random(20_241_127)
    lines = [mutated(random) for _ in range(COUNT)]
    failures = 0
    for line, (shown, status) in zip(lines, shell(lines, wait=WAIT), strict=True):
        assert status in STATUSES, (line, shown, status)
        # What a line prints of itself is no bug.
        assert not BUG.search(shown) or BUG.search(line), (line, shown)
        failures += status != 0
    assert failures > COUNT / 3
