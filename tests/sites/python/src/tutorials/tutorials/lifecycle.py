"""A managed node, through all of its states, by services and from within."""

import rclpy
from lifecycle_msgs.msg import TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetAvailableStates, GetAvailableTransitions, GetState
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, State, TransitionCallbackReturn
from std_msgs.msg import String

SUCCESS, FAILURE = TransitionCallbackReturn.SUCCESS, TransitionCallbackReturn.FAILURE
ERROR = TransitionCallbackReturn.ERROR


class Talker(LifecycleNode):
    """Says what happens to it; `answers` are what its next callbacks return."""

    def __init__(self):
        super().__init__("talker")
        self.answers = []
        self.publisher = self.create_lifecycle_publisher(String, "chatter", 10)

    def answer(self, name, state: State):
        """Say it and return the next answer."""
        print(name, state.label, state.state_id)
        answer = self.answers.pop(0) if self.answers else SUCCESS
        if answer is None:
            raise ValueError("on purpose")
        return answer

    def on_configure(self, state):
        """Be configured."""
        return self.answer("configure", state)

    def on_activate(self, state):
        """Be activated."""
        super().on_activate(state)
        return self.answer("activate", state)

    def on_deactivate(self, state):
        """Be deactivated."""
        super().on_deactivate(state)
        return self.answer("deactivate", state)

    def on_cleanup(self, state):
        """Be cleaned up."""
        return self.answer("cleanup", state)

    def on_shutdown(self, state):
        """Be shut down."""
        return self.answer("shutdown", state)

    def on_error(self, state):
        """Go on after an error."""
        return self.answer("error", state)


def main():
    """Change states in all ways."""
    rclpy.init()
    node, other = Talker(), rclpy.create_node("other")
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    executor.add_node(other)
    heard = []
    other.create_subscription(String, "chatter", lambda message: heard.append(message.data), 10)
    events = []
    other.create_subscription(TransitionEvent, "talker/transition_event", events.append, 100)

    def ask(kind, name, **fields):
        client = other.create_client(kind, f"talker/{name}")
        client.wait_for_service()
        future = client.call_async(kind.Request(**fields))
        executor.spin_until_future_complete(future, 10.0)
        return future.result()

    def change(**transition):
        request = ChangeState.Request()
        for field, value in transition.items():
            setattr(request.transition, field, value)
        success = ask(ChangeState, "change_state", **{"transition": request.transition}).success
        now = ask(GetState, "get_state").current_state
        print("->", transition, success, now.id, now.label)

    for state in ask(GetAvailableStates, "get_available_states").available_states:
        print(state.id, state.label)
    for name in ("get_available_transitions", "get_transition_graph"):
        answer = ask(GetAvailableTransitions, name)
        for each in answer.available_transitions:
            ends = each.start_state.label, each.goal_state.label
            print(each.transition.id, each.transition.label, *ends)

    node.publisher.publish(String(data="not heard"))
    change(label="configure")
    change(id=3)
    while not node.publisher.get_subscription_count():
        executor.spin_once(timeout_sec=0.1)
    node.publisher.publish(String(data="heard"))
    while not heard:
        executor.spin_once(timeout_sec=0.1)
    change(label="deactivate")
    node.publisher.publish(String(data="not heard either"))
    change(label="activate")
    change(label="nonsense")
    change(id=1)
    change(label="deactivate")
    node.answers = [FAILURE]
    change(label="cleanup")
    node.answers = [ERROR]
    change(label="cleanup")
    node.answers = [None, SUCCESS]
    change(label="configure")
    change(label="configure")
    change(label="shutdown")
    print(heard)
    print(node.trigger_configure())
    for _ in range(20):
        executor.spin_once(timeout_sec=0.05)
    for event in events:
        print(event.transition.label, event.start_state.label, event.goal_state.label)
    node.destroy_node()
    rclpy.shutdown()
