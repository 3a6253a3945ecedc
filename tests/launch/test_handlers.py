"""What a launch file does while its nodes run: what launch 3.7.1 and launch_ros 0.28.0 do then."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import launched
from sitegen.model import Effect, Handler

HEAD = """
from launch import LaunchDescription
from launch.events import *
from launch.events.process import *
from launch.actions import *
from launch.event_handlers import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.event_handlers import *
from launch_ros.events.lifecycle import ChangeState


def act(name, **given):
    return Node(package="mine", executable="act", name=name, **given)


def managed(name, **given):
    return LifecycleNode(package="mine", executable="act", name=name, namespace="/robot", **given)


def change(node, number):
    return EmitEvent(event=ChangeState(
        lifecycle_node_matcher=matches_action(node), transition_id=number))


def generate_launch_description():
"""


class Read:
    """A launch file, and what it does."""

    def __init__(self, root: Path, text: str, name: str = "x.launch.py") -> None:
        (root / name).write_text(text)
        problems, notes = Problems(root), Problems(root)
        found = launched(root / name, {}, workspace.scan(root), problems, notes)
        self.nodes = found.nodes
        self.problems, self.notes = problems.lines, notes.lines
        self.said = [told(handler) for handler in found.handlers]


def told(handler: Handler) -> str:
    """Return a handler as a line of text."""
    on = handler.on
    parts = [on.kind, *on.nodes, *([f"{on.after:g}s"] if on.after else [])]
    parts += ["ros"] if on.ros_time else []
    states = ("transition", "start_state", "goal_state")
    parts += [f"{name}={getattr(on, name)}" for name in states if getattr(on, name)]
    parts += [f"x{handler.most}"] if handler.most >= 0 else []
    return f"{' '.join(parts)}: {', '.join(map(done, handler.effects))}"


def done(effect: Effect) -> str:
    if effect.handler:
        return f"[{told(effect.handler)}]"
    numbers = map(str, effect.ids)
    return " ".join([effect.kind, *effect.nodes, *numbers, *filter(None, [effect.text])])


def python(root: Path, *lines: str) -> Read:
    return Read(root, HEAD + "".join(f"    {line}\n" for line in lines))


def test_timers_fire_later_and_in_each_other(root: Path) -> None:
    read = Read(
        root,
        """<launch>
        <timer period="2"><node pkg="mine" exec="act" name="late"/>
          <timer period="0.5"><node pkg="mine" exec="act" name="later"/></timer></timer>
        <node pkg="mine" exec="act" name="now"/></launch>""",
        "x.launch.xml",
    )
    assert read.said == ["time 2s x1: start late, [time 0.5s x1: start later]"]
    assert [node.name for node in read.nodes] == ["now", "late", "later"]


def test_the_scope_of_a_timer_is_that_of_its_time(root: Path) -> None:
    """With `echo`, launch printed: `late a=4`, `timer in group a=3 dir=…`, `sub dir=…/sub`."""
    (root / "sub").mkdir()
    (root / "sub" / "y.launch.xml").write_text(
        '<launch><timer period="1.5"><node pkg="mine" exec="act" name="sub" args="$(dirname)"/>'
        "</timer></launch>"
    )
    read = Read(
        root,
        """<launch><let name="a" value="1"/>
        <group><push_ros_namespace namespace="g"/><let name="a" value="2"/>
          <timer period="1"><let name="a" value="3"/>
            <node pkg="mine" exec="act" name="of_group" args="$(var a)"/></timer></group>
        <timer period="2"><node pkg="mine" exec="act" name="last" args="$(var a)"/></timer>
        <timer period="0.5"><node pkg="mine" exec="act" name="first" args="$(var a)"/></timer>
        <let name="a" value="4"/><include file="$(dirname)/sub/y.launch.xml"/></launch>""",
        "x.launch.xml",
    )
    found = {node.name: (*node.arguments, node.namespace) for node in read.nodes}
    assert found == {
        "first": ("4", ""),
        "of_group": ("3", ""),
        "sub": (f"{root}/sub", ""),
        "last": ("3", ""),
    }


def test_what_a_group_sets_is_gone_when_its_timer_fires(root: Path) -> None:
    """Natively: "launch configuration 'b' does not exist", and all nodes are stopped."""
    read = Read(
        root,
        """<launch><group><let name="b" value="1"/><timer period="1">
        <node pkg="mine" exec="act" args="$(var b)"/></timer></group></launch>""",
        "x.launch.xml",
    )
    assert read.problems == ["x.launch.xml:2: node: argument 'b' is not set"]


def test_events_of_processes(root: Path) -> None:
    read = python(
        root,
        "first, second = act('first'), act('second')",
        "process = ExecuteProcess(cmd=['ros2', 'run', 'mine', 'act'])",
        "return LaunchDescription([",
        "    RegisterEventHandler(OnProcessExit(target_action=first, on_exit=second)),",
        "    RegisterEventHandler(OnProcessStart(target_action=process, handle_once=True,",
        "        on_start=[LogInfo(msg='a')])),",
        "    RegisterEventHandler(OnProcessExit(on_exit=[EmitEvent(event=ShutdownProcess(",
        "        process_matcher=matches_action(first)))])),",
        "    RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg=[",
        "        'because ', LocalSubstitution('event.reason')])])),",
        "    RegisterEventHandler(OnExecutionComplete(target_action=second, on_completion=[",
        "        TimerAction(period=1.0, actions=[Shutdown(reason='over')])])),",
        "    first, process,",
        "])",
    )
    assert read.problems == []
    assert read.said == [
        "exited first: start second",
        "started act x1: log a",
        "exited: stop first",
        "shutdown: log because \ue000event.reason\ue001",
        "exited second: [time 1s x1: shutdown over]",
    ]


def test_what_a_node_does_when_it_ends(root: Path) -> None:
    read = python(
        root,
        "return LaunchDescription([",
        "    act('required', on_exit=Shutdown(reason='required')),",
        "    act('before', on_exit=[act('after'), LogInfo(msg='next')]),",
        "    act('again', respawn=True, respawn_delay=2.5, respawn_max_retries=3),",
        "    ExecuteProcess(cmd=['ros2', 'run', 'mine', 'act'], respawn=True,",
        "        on_exit=[Shutdown()]),",
        "])",
    )
    assert read.problems == []
    assert sorted(read.said) == [
        "ended act 1s: start act",
        "ended again 2.5s x3: start again",
        "exited act: shutdown",
        "exited before: start after, log next",
        "exited required: shutdown required",
    ]


def test_states_of_managed_nodes(root: Path) -> None:
    read = python(
        root,
        "one, two = managed('one'), managed('two', autostart=True)",
        "return LaunchDescription([",
        "    one, two, change(one, 1),",
        "    LifecycleTransition(lifecycle_node_names=['/robot/one', 'robot/two'],",
        "        transition_ids=[1, '3']),",
        "    RegisterEventHandler(OnStateTransition(target_lifecycle_node=one,",
        "        start_state='configuring', goal_state='inactive', entities=[change(one, 3)])),",
        "    RegisterEventHandler(OnStateTransition(transition='activate',",
        "        entities=[act('third')])),",
        "    LifecycleTransition(lifecycle_node_names=['/robot/on'], transition_ids=[1]),",
        "])",
    )
    assert read.problems == []
    assert read.notes == [
        f"x.launch.py:{read.notes[0].split(':')[1]}: lifecycle_transition: no lifecycle node "
        "'/robot/on' in this launch file; did you mean '/robot/one'?"
    ]
    assert sorted(read.said) == [
        "started one: transition /robot/one 1",
        "started one: transition /robot/one 1 3",
        "started two: transition /robot/two 1 3",
        "started two: transition /robot/two 1 3",
        "state /robot/one /robot/two transition=activate: start third",
        "state /robot/one start_state=configuring goal_state=inactive: transition /robot/one 3",
    ]


def test_a_handler_finds_the_node_of_a_function_or_of_another_handler(root: Path) -> None:
    """Each call of a function makes nodes of its own; a file may be included twice."""
    (root / "part.launch.py").write_text(
        HEAD
        + "".join(
            f"    {line}\n"
            for line in (
                "def made(context):",
                "    name = LaunchConfiguration('side').perform(context)",
                "    arm, hand = act('arm_' + name), act('hand_' + name)",
                "    return [arm, RegisterEventHandler(OnProcessExit(target_action=arm,",
                "        on_exit=[hand])), RegisterEventHandler(OnProcessStart(target_action=hand,",
                "        on_start=[act('finger_' + name)]))]",
                "return LaunchDescription([OpaqueFunction(function=made),",
                "    OpaqueFunction(function=lambda context: [act('plain', condition=None)])])",
            )
        )
    )
    read = Read(
        root,
        """<launch>
        <include file="$(dirname)/part.launch.py"><arg name="side" value="left"/></include>
        <include file="$(dirname)/part.launch.py"><arg name="side" value="right"/></include>
        </launch>""",
        "x.launch.xml",
    )
    assert read.problems == []
    assert sorted(read.said) == [
        "exited arm_left: start hand_left",
        "exited arm_right: start hand_right",
        "started hand_left: start finger_left",
        "started hand_right: start finger_right",
    ]


@pytest.mark.parametrize(
    ("event", "said", "notes", "names"),
    [
        ("OnProcessStart(target_action=other, on_start=[act('next')])", [], 0, ["next"]),
        ("OnProcessExit(target_action=other, on_exit=[act('next')])", [], 1, []),
        ("OnProcessExit(target_action=never, on_exit=[act('next')])", [], 0, []),
    ],
)
def test_programs_that_are_skipped(
    root: Path, event: str, said: list[str], notes: int, names: list[str]
) -> None:
    """What follows the start of one starts with all others; what follows its end never does."""
    read = python(
        root,
        "other, never = ExecuteProcess(cmd=['gazebo']), act('never')",
        f"return LaunchDescription([other, RegisterEventHandler({event})])",
    )
    assert read.problems == []
    assert [node.name for node in read.nodes] == names
    assert sum("what it waits for does not run" in line for line in read.notes) == notes
    starts = [f"launched: start {name}" for name in names]
    assert read.said == [*said, *starts]


def test_ros_time_is_simulated_only_if_it_is_set(root: Path) -> None:
    timer = '<ros_timer period="1"><node pkg="mine" exec="act"/></ros_timer>'
    read = Read(root, f"<launch>{timer}</launch>", "x.launch.xml")
    assert read.said == ["time 1s x1: start act"]
    sim = '<set_use_sim_time value="true"/>'
    read = Read(root, f"<launch>{sim}{timer}</launch>", "x.launch.xml")
    assert read.said == ["time 1s ros x1: start act"]


def test_what_an_event_says_is_not_given_to_nodes(root: Path) -> None:
    read = python(
        root,
        "return LaunchDescription([RegisterEventHandler(OnProcessExit(on_exit=[",
        "    act('next', arguments=['code', ['=', LocalSubstitution('event.returncode')]])]))])",
    )
    assert read.nodes[0].arguments == ("code", "=")
    assert [line.split(": ", 1)[1] for line in read.notes] == [
        "args: what an event says is left out here; it can be logged, but not given to a node"
    ]


def test_components_are_in_their_container_from_the_start(root: Path) -> None:
    read = Read(
        root,
        """<launch>
        <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace=""/>
        <timer period="1"><load_composable_node target="/c">
          <composable_node pkg="mine" plugin="P" name="p"/></load_composable_node></timer>
        </launch>""",
        "x.launch.xml",
    )
    assert read.problems == []
    assert read.notes == [
        "x.launch.xml:3: load_composable_node: a page loads components with their container, "
        "not later"
    ]
