"""roslib 2 as it comes from npm, on the graph of a page with C++ nodes."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import Built, Serve
from panel import Panel
from paths import SITES
from playwright.sync_api import Page
from roslib import with_roslib


@pytest.mark.firefox
def test_topics_are_heard_and_published(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const heard = await until((resolve) => {
            const chatter = new ROSLIB.Topic({ ros: link, name: "/chatter",
              messageType: "std_msgs/String" });
            chatter.subscribe((message) => { chatter.unsubscribe(); resolve(message); });
          });
          const latched = await until((resolve) =>
            link.Topic({ name: "/latched",
              messageType: "std_msgs/msg/String" }).subscribe(resolve));
          link.Topic({ name: "/echo",
            messageType: "std_msgs/String" }).publish({ data: "from roslib" });
          return [Object.keys(heard), heard.data.split(" ")[0], latched];
        }"""
    )
    assert found == [["data"], "Hello", {"data": "once"}]
    Panel(page, "robot").wait_for("heard 'from roslib'")


def test_a_topic_is_latched(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const options = { name: "/mine", messageType: "std_msgs/Int64" };
          const out = link.Topic({ ...options, latch: true });
          for (let i = 1; i < 4; i++) out.publish({ data: i });
          const other = await connected();
          const all = [];
          other.Topic(options).subscribe(({ data }) => all.push(data));
          await until((resolve) => other.Topic(options).subscribe(resolve));
          return all;
        }"""
    )
    assert found == [3]


def test_messages_are_throttled_and_queued(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const options = { name: "/count", messageType: "std_msgs/Int32" };
          const heard = { plain: [], sparse: [], queued: [] };
          const others = { plain: {}, sparse: { throttle_rate: 60_000 },
            queued: { throttle_rate: 100, queue_length: 3 } };
          const links = [];
          for (const [name, more] of Object.entries(others)) {
            const one = await connected();
            links.push(one);
            one.Topic({ ...options, ...more }).subscribe(({ data }) => heard[name].push(data));
          }
          const out = link.Topic(options);
          for (let i = 0; i < 10; i++) out.publish({ data: i });
          while (heard.plain.length < 10 || heard.queued.at(-1) !== 9) await pause(10);
          await pause(100);
          return heard;
        }"""
    )
    assert found["plain"] == [*range(10)]
    assert found["sparse"] == [0]
    # On a busy machine, the messages do not all come at once.
    assert found["queued"][0] == 0
    assert found["queued"][-3:] == [7, 8, 9]
    assert len(found["queued"]) < 8


def test_services_are_called_both_ways(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const call = (name, request, timeout) => until((resolve) =>
            link.Service({ name, serviceType: "any/Any" }).callService(request, resolve,
              (error) => resolve({ error }), timeout));
          const server = link.Service({ name: "/page/add",
            serviceType: "example_interfaces/AddTwoInts" });
          await server.advertiseAsync(async ({ a, b }) => ({ sum: a + b }));
          const silent = link.Service({ name: "/silent", serviceType: "std_srvs/Trigger" });
          await silent.advertise(() => false);
          return {
            sum: await call("/add_two_ints", { a: 40, b: 2 }), listed: await call("/add_two_ints",
              [1, 2]),
            own: await call("/page/add", { a: 3, b: 4 }),
            none: await call("/none", {}), wrong: await call("/add_two_ints", { c: 1 }),
            silent: await call("/silent", {}, 0.1),
          };
        }"""
    )
    assert found == {
        "sum": {"sum": 42},
        "listed": {"sum": 3},
        "own": {"sum": 7},
        "none": {"error": "there is no service /none"},
        "wrong": {"error": "example_interfaces/AddTwoInts_Request has no field 'c'"},
        "silent": {"error": "no response from /silent within 0.1 s"},
    }


def test_goals_are_sent_canceled_and_refused(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const action = new ROSLIB.Action({ ros: link, name: "/fibonacci",
            actionType: "example_interfaces/Fibonacci" });
          const steps = [];
          const run = (order, feedback = () => {}) => until((resolve) => {
            const id = action.sendGoal({ order }, (result) => resolve(result.sequence.length),
              (values) => feedback(values, id), (error) => resolve(error.split(":")[0]));
          });
          return {
            done: await run(5, ({ sequence }) => steps.push(sequence.length)), steps,
            canceled: await run(10_000, (_, id) => action.cancelGoal(id)),
            aborted: await run(13),
            rejected: await run(-1),
          };
        }"""
    )
    assert found == {
        "done": 6,
        "steps": [3, 4, 5, 6],
        "canceled": "GoalError",
        "aborted": "GoalError",
        "rejected": "GoalError",
    }


def test_compiled_nodes_call_what_roslib_serves(page: Page) -> None:
    page.evaluate(
        """async () => {
          const server = link.Service({ name: "/page/add",
            serviceType: "example_interfaces/srv/AddTwoInts" });
          await server.advertise(({ a, b }, response) => { response.sum = a + b; return true; });
          const canceled = new Set();
          const action = new ROSLIB.Action({ ros: link, name: "/page/fibonacci",
            actionType: "example_interfaces/action/Fibonacci" });
          action.advertise(async ({ order }, id) => {
            const sequence = [0, 1];
            for (let i = 1; i < order; i++) {
              sequence.push(i);
              action.sendFeedback(id, { sequence });
              await pause(5);
              if (canceled.has(id)) { action.setCanceled(id, { sequence }); return; }
            }
            action.setSucceeded(id, { sequence });
          }, (id) => canceled.add(id));
        }"""
    )
    asker = Panel(page, "asker")
    asker.start()
    asker.expect_state("stopped")
    first, second, third = asker.messages()
    assert first == "sum 42"
    assert second == "order 5: code 4, 6 numbers, feedback"
    assert third.startswith("order 1000: code 5, "), "canceled"


def test_parameters_are_set_and_read(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const get = (name) => until((resolve) => link.Param({ name }).get(resolve, (error) =>
            resolve({ error })));
          const set = (name, value) => until((resolve) => link.Param({ name }).set(value, resolve,
            (error) => resolve({ error })));
          const set1 = await set("/robot:speed", 7);
          return {
            set: set1, speed: await get("/robot:speed"), label: await get("/robot:label"),
            sim: [await set("/robot:use_sim_time", true), await get("robot:use_sim_time")],
            names: await until((resolve) => link.getParams(resolve)),
            wrong: await set("/robot:count", "x"), none: await get("/robot:none"),
              odd: await get("no name"),
          };
        }"""
    )
    fine = {"successful": True, "reason": ""}
    assert {"/robot:speed", "/robot:use_sim_time"} <= set(found.pop("names"))
    assert found.pop("wrong")["error"].startswith("/robot refused: ")
    assert found == {
        "set": fine,
        "speed": 7,
        "label": "first",
        "sim": [fine, True],
        "none": {"error": "parameter /robot:none is not set"},
        "odd": {"error": "'no name' is not the name of a parameter; write '/node:parameter'"},
    }


def test_tf_clients_hear_transforms(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const options = { ros: link, fixedFrame: "world", angularThres: 0.01, transThres: 0.01,
            rate: 50 };
          const heard = async (client, frame) => {
            const places = [];
            await until((resolve) => client.subscribe(frame, ({ translation, rotation }) => {
              if (places.push(translation.x) === 2 || frame === "/map") resolve(rotation);
            }));
            client.dispose();
            return places;
          };
          return {
            moving: await heard(new ROSLIB.ROS2TFClient(options), "turtle1"),
            fixed: await heard(new ROSLIB.ROS2TFClient(options), "/map"),
            old: await heard(link.TFClient(options), "turtle1"),
          };
        }"""
    )
    assert found["fixed"] == [10]
    for one, two in (found["moving"], found["old"]):
        assert 10 < one < two


def test_the_action_client_of_ros_1_reaches_actions_of_ros_2(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const client = link.ActionClient({ serverName: "/fibonacci",
            actionName: "actionlib_tutorials/FibonacciAction" });
          const goal = new ROSLIB.Goal({ actionClient: client, goalMessage: { order: 7 } });
          const steps = [];
          goal.on("feedback", ({ sequence }) => steps.push(sequence.length));
          goal.send();
          const { sequence } = await until((resolve) => goal.on("result", resolve));
          return { steps, sequence, status: goal.status.status };
        }"""
    )
    assert found == {
        "steps": [3, 4, 5, 6, 7, 8],
        "sequence": [0, 1, 1, 2, 3, 5, 8, 13],
        "status": 3,
    }


def test_a_connection_closes_and_opens_again(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const other = await connected();
          const topic = other.Topic({ name: "/mine", messageType: "std_msgs/String" });
          topic.advertise();
          topic.subscribe(() => {});
          const there = () => ros.topics().some(({ name }) => name === "/mine");
          const before = there();
          const closed = until((resolve) => other.on("close", resolve));
          other.close();
          await closed;
          const after = [there(), other.isConnected];
          await other.connect("page:");
          await until((resolve) => other.on("connection", resolve));
          return { before, after, again: there(), connected: other.isConnected };
        }"""
    )
    assert found == {"before": True, "after": [False, False], "again": True, "connected": True}


def test_a_description_of_a_robot_is_read(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const text = `<robot name="arm"><link name="base"/><link name="tool"/>
            <joint name="turn" type="revolute"><parent link="base"/><child link="tool"/></joint>
          </robot>`;
          const options = { name: "/robot_description", messageType: "std_msgs/String" };
          link.Topic({ ...options, latch: true }).publish({ data: text });
          const other = await connected();
          const { data } = await until((resolve) => other.Topic(options).subscribe(resolve));
          const { name, joints, links } = new ROSLIB.UrdfModel({ string: data });
          return [name, Object.keys(links), joints.turn.parent, joints.turn.child];
        }"""
    )
    assert found == ["arm", ["base", "tool"], "base", "tool"]


def test_a_server_and_a_client_of_the_tutorial_meet(page: Page) -> None:
    """What roslib's examples of actions do, in two connections."""
    found = page.evaluate(
        """async () => {
          const options = { name: "/tutorial",
            actionType: "action_tutorials_interfaces/Fibonacci" };
          const server = new ROSLIB.Action({ ros: link, ...options });
          server.advertise(({ order }, id) => {
            if (order > 47) { server.setFailed(id); return; }
            const sequence = [0, 1];
            for (let i = 1; i < order; i++) {
              sequence.push(sequence[i] + sequence[i - 1]);
              server.sendFeedback(id, { partial_sequence: sequence });
            }
            server.setSucceeded(id, { sequence });
          }, () => {});
          const client = new ROSLIB.Action({ ros: await connected(), ...options });
          const steps = [];
          const run = (order) => until((resolve) => client.sendGoal({ order },
            ({ sequence }) => resolve(sequence),
            ({ partial_sequence: one }) => steps.push(one.length),
            (error) => resolve(error.split(":")[1].trim())));
          return { sequence: await run(5), steps, failed: await run(48) };
        }"""
    )
    assert found == {
        "sequence": [0, 1, 1, 2, 3, 5],
        "steps": [3, 4, 5, 6],
        "failed": "Action was aborted",
    }


def test_an_own_bundle_works_beside_the_one_of_sitegen(
    tab: Page, serve: Serve, built: Built, tmp_path: Path
) -> None:
    tab.goto(serve(with_roslib(built(SITES / "scripts"), tmp_path)))
    tab.wait_for_selector("body[data-scripted]")
    found = tab.evaluate(
        """async () => {
          const own = await import("/roslib.js");
          const [out, heard] = [own, ROSLIB].map(({ Ros, Topic }) => {
            const ros = new Ros({ url: "page:", transportFactory: rosbridge.transportFactory });
            return new Topic({ ros, name: "/mine", messageType: "std_msgs/String", latch: true });
          });
          out.publish({ data: "hello" });
          return [own.Ros !== ROSLIB.Ros, await new Promise((resolve) => heard.subscribe(resolve))];
        }"""
    )
    assert found == [True, {"data": "hello"}]
