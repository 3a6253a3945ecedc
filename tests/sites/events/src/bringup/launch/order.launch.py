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


def generate_launch_description():
    first = act("first", "0.5", "3")
    second = act("second")
    managed = LifecycleNode(package="acting", executable="act", name="managed", namespace="/robot")
    return LaunchDescription(
        [
            LogInfo(msg="begins"),
            first,
            managed,
            act("managed_2"),
            LifecycleNode(
                package="acting", executable="act", name="auto", namespace="", autostart=True
            ),
            TimerAction(
                period=0.2,
                actions=[
                    act("late"),
                    TimerAction(
                        period=0.2,
                        actions=[
                            act("later"),
                        ],
                    ),
                ],
            ),
            RegisterEventHandler(
                OnProcessExit(
                    target_action=first,
                    on_exit=[
                        LogInfo(
                            msg=["first has ended with ", LocalSubstitution("event.returncode")]
                        ),
                        second,
                        LifecycleTransition(
                            lifecycle_node_names=["robot/managed"], transition_ids=[4, 2, 1]
                        ),
                    ],
                )
            ),
            RegisterEventHandler(
                OnProcessStart(
                    target_action=second,
                    on_start=[
                        LogInfo(msg="second is up"),
                    ],
                )
            ),
            change(managed, Transition.TRANSITION_CONFIGURE),
            RegisterEventHandler(
                OnStateTransition(
                    target_lifecycle_node=managed,
                    start_state="configuring",
                    goal_state="inactive",
                    entities=[LogInfo(msg="configured"), change(managed, 3)],
                )
            ),
            RegisterEventHandler(
                OnStateTransition(
                    target_lifecycle_node=managed,
                    goal_state="active",
                    entities=[LogInfo(msg=["managed is ", LocalSubstitution("event.goal_state")])],
                )
            ),
        ]
    )
