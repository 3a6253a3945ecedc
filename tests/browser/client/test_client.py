"""The module `sitegen` in a script of a page, with C++ nodes and without any."""

from __future__ import annotations

from typing import Any

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Page

SITE = SITES / "scripts"


@pytest.fixture
def page(tab: Page, serve: Serve, built: Built) -> Page:
    """A page with a script, beside the node /robot."""
    tab.goto(serve(built(SITE)))
    tab.wait_for_selector("body[data-scripted]")
    # The last thing that the node makes.
    tab.evaluate("() => ros.action('/fibonacci').wait()")
    return tab


@pytest.mark.firefox
def test_messages_come_as_they_are_asked_for(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const chatter = ros.topic("chatter");
          const heard = [];
          for await (const { data } of chatter.messages()) if (heard.push(data) === 3) break;
          const stop = new AbortController();
          const rest = [];
          for await (const { data } of chatter.messages({ signal: stop.signal })) {
            rest.push(data);
            stop.abort();
          }
          const latched = await ros.topic("/latched").next();
          return { heard, type: chatter.type, rest: rest.length, latched: latched.data };
        }"""
    )
    first = int(found["heard"][0].removeprefix("Hello "))
    assert found == {
        "heard": [f"Hello {first + index}" for index in range(3)],
        "type": "std_msgs/msg/String",
        "rest": 1,
        "latched": "once",
    }


def test_a_script_publishes(page: Page) -> None:
    page.evaluate(
        """async () => {
          const echo = ros.topic("/echo");
          echo.publish({ data: "from a script" });
        }"""
    )
    Panel(page, "robot").wait_for("heard 'from a script'")


def test_a_subscription_hears_what_a_node_latched_before_it_was_known(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const robot = ros.programs.get("robot");
          const state = (wanted) => new Promise((resolve) => {
            const look = () => { if (robot.state === wanted) resolve(); };
            robot.addEventListener("state", look);
            look();
          });
          robot.stop();
          await state("stopped");
          const heard = [];
          ros.topic("/latched", "std_msgs/msg/String").subscribe(({ data }) => heard.push(data));
          const chatter = ros.topic("/chatter", "std_msgs/msg/String").messages();
          robot.start();
          const all = [];
          for await (const { data } of chatter) if (all.push(data) === 20) break;
          return [heard, new Set(all).size];
        }"""
    )
    assert found == [["once"], 20]


def test_services_answer_scripts(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const add = ros.service("/add_two_ints");
          const { sum } = await add.call({ a: 40n, b: 2n });
          const fault = await ros.service("/none", "std_srvs/srv/SetBool").call({}, { timeout: 50 })
            .catch((error) => error.message);
          const gone = new AbortController();
          const waiting = ros.service("/none").wait({ signal: gone.signal }).catch((error) =>
            error.message);
          gone.abort(new Error("enough"));
          return [String(sum), add.type, add.available, fault, await waiting];
        }"""
    )
    assert found == [
        "42",
        "example_interfaces/srv/AddTwoInts",
        True,
        "no server for /none within 0.05 s",
        "enough",
    ]


def test_goals_have_feedback_and_results(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const fibonacci = ros.action("/fibonacci");
          const goal = await fibonacci.send({ order: 5 });
          const steps = [];
          for await (const { sequence } of goal.feedback()) steps.push(sequence.length);
          const { sequence } = await goal.result();
          const outcome = async (order, also = () => {}) => {
            const other = await fibonacci.send({ order });
            await also(other);
            return other.result().catch((error) =>
              [error instanceof GoalError, error.state,
                Array.from(error.result?.sequence ?? []).length > 0]);
          };
          const cancel = async (other) => {
            for await (const _ of other.feedback()) break;
            await other.cancel();
          };
          return {
            steps, sequence: [...sequence], state: goal.state, rejected: await outcome(-1),
            aborted: await outcome(13), canceled: await outcome(10_000, cancel),
          };
        }"""
    )
    assert found == {
        "steps": [3, 4, 5, 6],
        "sequence": [0, 1, 1, 2, 3, 5],
        "state": "succeeded",
        "rejected": [True, "rejected", False],
        "aborted": [True, "aborted", True],
        "canceled": [True, "canceled", True],
    }


SERVING = """() => {
  ros.service("/page/add", "example_interfaces/srv/AddTwoInts").serve(async ({ a, b }) =>
    ({ sum: a + b }));
  ros.action("/page/fibonacci",
    "example_interfaces/action/Fibonacci").serve(async function* (task) {
    const sequence = [0, 1];
    for (let i = 1; i < task.request.order; i++) {
      sequence.push(0);
      yield { sequence };
      await new Promise((resolve) => setTimeout(resolve, 5));
      if (task.signal.aborted) break;
    }
    return { sequence };
  });
}"""


def test_compiled_nodes_call_what_scripts_serve(page: Page) -> None:
    page.evaluate(SERVING)
    asker = Panel(page, "asker")
    asker.start()
    asker.expect_state("stopped")
    first, second, third = asker.messages()
    assert first == "sum 42"
    assert second == "order 5: code 4, 6 numbers, feedback"
    # The goal may be canceled before its first step.
    assert third.startswith("order 1000: code 5, "), "canceled"


def test_parameters_are_read_set_and_followed(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const robot = ros.parameters("/robot");
          const before = await robot.all();
          const changes = robot.changes();
          await robot.set("speed", 2);
          await robot.set({ count: 5, label: "second" });
          const told = [];
          for await (const one of changes) if (told.push(one) === 3) break;
          return {
            before: [before.speed, before.count, before.label], told,
            speed: await robot.get("speed"), none: (await robot.get("none")) ?? "none",
            names: (await robot.names()).includes("label"),
            fault: await robot.set("count", "many").catch((error) => error.message),
            nobody: await ros.parameters("/nobody").get("a").catch((error) => error.message),
          };
        }"""
    )
    fault = found.pop("fault")
    assert found == {
        "before": [1.5, 3, "first"],
        "told": [
            {"name": "speed", "value": 2},
            {"name": "count", "value": 5},
            {"name": "label", "value": "second"},
        ],
        "speed": 2,
        "none": "none",
        "names": True,
        "nobody": "/nobody has no parameters, or is not running",
    }
    assert fault.startswith("/robot refused: ")


def test_transforms_are_looked_up_and_followed(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const { translation } = await ros.tf.lookup("world", "map");
          const places = [];
          for await (const one of ros.tf.follow("world",
            "turtle1")) if (places.push(one.translation.x) === 3) break;
          const fault = await ros.tf.lookup("world", "moon", { timeout: 50 }).catch((error) =>
            error.message);
          return { fixed: translation.x, places, frames: ros.tf.frames(), fault };
        }"""
    )
    assert found["fixed"] == 10
    assert found["places"] == sorted(set(found["places"]))
    assert found["places"][0] > 10
    assert found["frames"] == ["map", "turtle1", "world"]
    assert found["fault"] == "no frame 'moon' in /tf"


def test_a_script_sees_the_graph_change(page: Page) -> None:
    found: Any = page.evaluate(
        """async () => {
          const events = ros.events();
          const other = ros.node("/dashboard");
          other.topic("~/state", "std_msgs/Bool").advertise();
          const told = [];
          for await (const one of events) {
            if (one.node !== "/dashboard" || !["", "/dashboard/state"].includes(one.name)) continue;
            told.push(`${one.change} ${one.kind} ${one.name}`);
            if (told.length === 2) other.close();
            if (told.length === 4) break;
          }
          return { told, nodes: ros.nodes(), actions: ros.actions().map(({ name }) => name) };
        }"""
    )
    assert found["told"] == [
        "come node ",
        "come publisher /dashboard/state",
        "gone node ",
        "gone publisher /dashboard/state",
    ]
    assert "/robot" in found["nodes"]
    assert "/dashboard" not in found["nodes"]
    assert found["actions"] == ["/fibonacci"]


def test_mistakes_have_clear_errors(page: Page) -> None:
    found = page.evaluate(
        """() => [
          () => ros.topic("/a b"), () => ros.topic("/new").publish({}), () => ros.topic("/new",
            "String"),
          () => ros.topic("/new", "no_msgs/msg/No").publish({}), () => ros.service("/s",
            "std_msgs/msg/String"),
          () => ros.topic("/" + "a".repeat(300)),
        ].map((work) => { try { work(); return "nothing"; } catch (error) { return error.message;
        } })"""
    )
    assert found.pop().endswith("aaa' is not a valid name in ROS")
    assert found == [
        "'/a b' is not a valid name in ROS",
        "give /new a type: the graph has no such topic",
        "'String' is not a valid type; write it like 'std_msgs/msg/String'",
        "/new: this page has no definition of no_msgs/msg/No",
        "'std_msgs/msg/String' is not a valid type; write it like 'std_srvs/srv/SetBool'",
    ]


def test_a_page_without_widgets_has_a_script_and_nodes(
    tab: Page, serve: Serve, built: Built
) -> None:
    tab.goto(f"{serve(built(SITE))}alone/")
    tab.wait_for_selector("body[data-scripted]")
    found = tab.evaluate(
        """async () => {
          const heard = await ros.topic("/chatter", "std_msgs/String").next();
          return [heard.data.split(" ")[0], ros.programs.get("silent").state];
        }"""
    )
    assert found == ["Hello", "running"]
