"""A signal ends whatever a script has begun with it."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page

BEGIN = """() => {
  globalThis.stop = new AbortController();
  globalThis.told = ({ message }) => message;
}"""


@pytest.fixture(autouse=True)
def begun(scripted: Page) -> None:
    scripted.evaluate(BEGIN)


def test_subscriptions_publishers_and_services_end(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          const { signal } = stop;
          const ticks = ros.topic("/ticks", "std_msgs/msg/UInt8");
          const heard = [];
          ticks.subscribe(({ data }) => heard.push(data), { signal, qos: { depth: 1 } });
          ticks.advertise({ signal });
          const all = ticks.messages();
          ticks.publish({ data: 1 });
          await all.next();
          ros.service("/page/state", "std_srvs/srv/Trigger")
            .serve(() => ({ success: true }), { signal });
          const made = ros.node("/made", { signal });
          const there = () => [ros.services().length, ros.nodes().length,
            ros.topics().find(({ name }) => name === "/ticks")];
          const before = there();
          stop.abort(new Error("enough"));
          const after = there();
          ticks.publish({ data: 2 });
          await all.next();
          // Nothing begins with a signal that is aborted already.
          ticks.subscribe(({ data }) => heard.push(data), { signal });
          ros.service("/page/state", "std_srvs/srv/Trigger").serve(() => ({}), { signal });
          let late;
          try { ros.node("/late", { signal }); } catch (error) { late = error.message; }
          const of = ({ publishers, subscriptions } = {}) =>
            [publishers?.length, subscriptions?.length];
          return {
            heard, late, before: [...before.slice(0, 2), ...of(before[2])],
            after: [...after.slice(0, 2), ...of(after[2])], services: ros.services().length,
          };
        }"""
    )
    assert found == {
        "heard": [1],
        "late": "enough",
        "before": [7, 1, 1, 2],
        "after": [0, 0, 0, 1],
        "services": 0,
    }


def test_aborting_what_sent_a_goal_cancels_it(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          const canceled = [];
          const count = ros.action("/count", "example_interfaces/action/Fibonacci");
          const end = count.serve(({ id, signal }) => new Promise((resolve) => {
            signal.addEventListener("abort", () => {
              canceled.push(id);
              resolve({ sequence: [7] });
            });
          }));
          // At once, while the server has not answered, and later.
          const early = new AbortController();
          const soon = await count.send({ order: 1 }, { signal: early.signal });
          early.abort();
          const goal = await count.send({ order: 1 }, { signal: stop.signal });
          const impatient = await goal.result({ signal: AbortSignal.timeout(1) })
            .catch(({ name }) => name);
          const during = goal.state;
          stop.abort();
          const results = [];
          for (const one of [soon, goal]) {
            results.push(await one.result().catch(({ name, state, result }) =>
              [name, state, result.sequence[0]]));
          }
          const late = await goal.cancel({ signal: stop.signal }).catch(({ name }) => name);
          end();
          return { impatient, during, results, late,
            canceled: canceled.includes(goal.id) };
        }"""
    )
    assert found == {
        "impatient": "TimeoutError",
        "during": "executing",
        "results": [["GoalError", "canceled", None], ["GoalError", "canceled", 7]],
        "late": "AbortError",
        "canceled": True,
    }


def test_a_server_of_an_action_ends(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          let begin;
          const begun = new Promise((resolve) => { begin = resolve; });
          const wait = ({ signal }) => new Promise((_, reject) => {
            signal.addEventListener("abort", () => reject(signal.reason));
            begin();
          });
          const count = ros.action("/count", "example_interfaces/action/Fibonacci");
          count.serve(wait, { signal: stop.signal });
          const goal = await count.send({ order: 1 });
          await begun;
          stop.abort(new Error("enough"));
          const state = await goal.result().catch(({ state }) => state);
          for await (const _ of ros.events()) if (!count.available) break;
          return [state, count.available];
        }"""
    )
    assert found == ["aborted", False]


def test_questions_to_nodes_end(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          // One that never answers, and one that is not there.
          const SRV = "rcl_interfaces/srv";
          for (const [name, type] of [["get", "Get"], ["list", "List"], ["describe", "Describe"]]) {
            ros.service(`/mute/${name}_parameters`, `${SRV}/${type}Parameters`)
              .serve(() => new Promise(() => {}));
          }
          const { signal } = stop;
          const waiting = ["/mute", "/none"].map((node) => ros.parameters(node)).flatMap((one) => [
            one.get("a", { signal }), one.names({ signal }), one.all({ signal }),
            one.describe("a", { signal }), one.set("a", 1, { signal }),
            one.set({ a: 1 }, { signal }),
          ]).map((one) => one.catch(told));
          stop.abort(new Error("enough"));
          const short = await ros.parameters("/mute").get("a", { timeout: 1 }).catch(told);
          return [new Set(await Promise.all(waiting)), short].map((one) =>
            one instanceof Set ? [...one] : one);
        }"""
    )
    assert found == [["enough"], "no response from /mute/get_parameters within 0.001 s"]
