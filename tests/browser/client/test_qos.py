"""Quality of service as scripts write it."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page

# Returns the policies of a publisher on the graph of the page.
OFFERED = """async (qos) => {
  const { ros: page } = await import(document.querySelector("script[type=module]").src);
  const node = ros.node("/offering");
  try {
    node.topic("/offered", "std_msgs/msg/String", qos).advertise();
    const { depth, reliable, transientLocal, keepAll, deadline, manual } =
      page.graph.endpoints().find(({ name }) => name === "/offered").qos;
    return [depth, reliable, transientLocal, keepAll, deadline, manual];
  } catch (error) {
    return error.message;
  } finally {
    node.close();
  }
}"""
DEFAULT = [10, True, False, False, float("inf"), False]


@pytest.mark.parametrize(
    ("qos", "offered"),
    [
        ({}, DEFAULT),
        ("default", DEFAULT),
        ("system_default", DEFAULT),
        ("sensor_data", [5, False, False, False, float("inf"), False]),
        ("SENSOR_DATA", [5, False, False, False, float("inf"), False]),
        ("parameters", [1000, *DEFAULT[1:]]),
        ("action_status_default", [1, True, True, *DEFAULT[3:]]),
        ({"profile": "sensor_data", "depth": 2}, [2, False, False, False, float("inf"), False]),
        ({"reliability": "best_effort"}, [10, False, *DEFAULT[2:]]),
        (
            {"durability": "transient_local", "history": "keep_all", "deadline": 50},
            [10, True, True, True, 50, False],
        ),
        ({"liveliness": "manual_by_topic"}, [*DEFAULT[:5], True]),
        ({"reliable": False, "transientLocal": True}, [10, False, True, *DEFAULT[3:]]),
        ({"depth": 0}, [1, *DEFAULT[1:]]),
    ],
)
def test_policies_have_names(scripted: Page, qos: object, offered: object) -> None:
    assert scripted.evaluate(OFFERED, qos) == offered


@pytest.mark.parametrize(
    ("qos", "fault"),
    [
        (
            "sensors",
            "qos: unknown profile 'sensors'; known are default, system_default, best_available, "
            "sensor_data, services_default, parameters, parameter_events, action_status_default",
        ),
        (
            {"reliability": "besteffort"},
            "qos: unknown reliability 'besteffort'; known are reliable, best_effort, "
            "best_available",
        ),
        (
            {"reliabel": True},
            "qos: unknown policy 'reliabel'; known are profile, reliable, transientLocal, keepAll, "
            "manual, depth, deadline, lifespan, lease, history, reliability, durability, "
            "liveliness",
        ),
        ({"reliable": "yes"}, "qos: 'reliable' must be true or false"),
        ({"depth": 1.5}, "qos: 'depth' must be a whole number"),
        ({"deadline": -1}, "qos: 'deadline' must be a time in ms"),
        (
            ["reliable"],
            "qos must be the name of a profile, such as 'sensor_data', or an object of policies",
        ),
        (
            7,
            "qos must be the name of a profile, such as 'sensor_data', or an object of policies",
        ),
    ],
)
def test_what_is_no_policy_is_an_error(scripted: Page, qos: object, fault: str) -> None:
    assert scripted.evaluate(OFFERED, qos) == fault


def test_subscriptions_take_policies_too(scripted: Page) -> None:
    found = scripted.evaluate(
        """() => {
          const topic = ros.topic("/heard", "std_msgs/msg/String");
          const fault = (act) => { try { act(); } catch (error) { return error.message; } };
          return [
            fault(() => topic.subscribe(() => {}, { qos: "sensors" })),
            fault(() => topic.subscribe(() => {}, { reliable: true })),
            fault(() => topic.messages({ qos: { dept: 1 } })),
            ros.topics().length,
          ];
        }"""
    )
    assert found[0].startswith("qos: unknown profile 'sensors'; known are default")
    assert found[1] == "/heard: unknown option 'reliable'; known are qos and signal"
    assert found[2].startswith("qos: unknown policy 'dept'; known are profile")
    assert found[3] == 0


def test_a_topic_is_iterated_over(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          const topic = ros.topic("/said", "std_msgs/msg/String");
          const latched = ros.topic("/said", "std_msgs/msg/String", "action_status_default");
          latched.publish({ data: "first" });
          const heard = [];
          for await (const { data } of topic) {
            if (heard.push(data) === 2) break;
            latched.publish({ data: "second" });
          }
          return heard;
        }"""
    )
    assert found == ["first", "second"]
