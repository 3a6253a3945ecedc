"""Nodes one after another: by time, by events, and by the states of a managed node."""

from launch import LaunchDescription
from launch.actions import EmitEvent, LogInfo, RegisterEventHandler, TimerAction
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch.events import matches_action
from launch.substitutions import LocalSubstitution
from launch_ros.actions import LifecycleNode, LifecycleTransition, Node
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import Transition


def act(name, *arguments):
    return Node(package="acting", executable="act", name=name, arguments=[*arguments])


def change(node, transition):
    return EmitEvent(
        event=ChangeState(lifecycle_node_matcher=matches_action(node), transition_id=transition)
    )


def on_state(node, actions, **states):
    handler = OnStateTransition(target_lifecycle_node=node, entities=actions, **states)
    return RegisterEventHandler(handler)


def generate_launch_description():
    first = act("first", "0.5", "3")
    second = act("second")
    managed = LifecycleNode(package="acting", executable="act", name="managed", namespace="/robot")
    auto = LifecycleNode(
        package="acting", executable="act", name="auto", namespace="", autostart=True
    )
    code = ["first has ended with ", LocalSubstitution("event.returncode")]
    state = ["managed is ", LocalSubstitution("event.goal_state")]
    ended = OnProcessExit(target_action=first, on_exit=[LogInfo(msg=code), second])
    started = OnProcessStart(target_action=second, on_start=[LogInfo(msg="second is up")])
    configured = [LogInfo(msg="configured"), change(managed, Transition.TRANSITION_ACTIVATE)]
    # The second of these fails.
    back = LifecycleTransition(lifecycle_node_names=["robot/managed"], transition_ids=[4, 2, 1])
    later = TimerAction(period=0.2, actions=[act("later")])
    return LaunchDescription(
        [
            LogInfo(msg="begins"),
            first,
            managed,
            act("managed_2"),
            auto,
            TimerAction(period=0.2, actions=[act("late"), later]),
            RegisterEventHandler(ended),
            RegisterEventHandler(started),
            change(managed, Transition.TRANSITION_CONFIGURE),
            on_state(managed, configured, start_state="configuring", goal_state="inactive"),
            on_state(managed, [LogInfo(msg=state), back], goal_state="active"),
        ]
    )
