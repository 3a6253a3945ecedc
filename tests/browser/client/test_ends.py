"""How streams of scripts end, and what they leave behind."""

from __future__ import annotations

from playwright.sync_api import Page

# A signal that counts its listeners.
COUNTED = """() => {
  globalThis.counted = () => {
    const controller = new AbortController();
    const { signal } = controller;
    const listeners = new Set();
    const { addEventListener: add, removeEventListener: remove } = signal;
    signal.addEventListener = (type, one, ...rest) => {
      listeners.add(one);
      add.call(signal, type, one, ...rest);
    };
    signal.removeEventListener = (type, one, ...rest) => {
      listeners.delete(one);
      remove.call(signal, type, one, ...rest);
    };
    return { controller, signal, listeners };
  };
}"""


def test_streams_that_ended_leave_no_listeners(scripted: Page) -> None:
    scripted.evaluate(COUNTED)
    found = scripted.evaluate(
        """async () => {
          const { controller, signal, listeners } = counted();
          const topic = ros.topic("/ticks", "std_msgs/msg/UInt8");
          const timer = setInterval(() => topic.publish({ data: 1 }), 1);
          for (let i = 0; i < 20; i++) await topic.next({ signal });
          for await (const _ of topic.messages({ signal })) break;
          const ended = listeners.size;
          const waiting = topic.messages({ signal });
          const during = listeners.size;
          controller.abort(new Error("enough"));
          const { done } = await waiting.next();
          clearInterval(timer);
          const late = await topic.next({ signal }).catch((error) => error.message);
          return { ended, during, done, left: listeners.size, late };
        }"""
    )
    assert found == {"ended": 0, "during": 1, "done": True, "left": 0, "late": "enough"}


def test_closing_a_node_ends_what_it_waits_for(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          const late = (resolve) => setTimeout(() => resolve("still waiting"), 5000);
          const told = (promise) => Promise.race([promise.then(({ done }) => done ?? "value",
            (error) => error.message), new Promise(late)]);
          ros.action("/slow", "example_interfaces/action/Fibonacci").serve(({ signal }) =>
            new Promise((resolve) => signal.addEventListener("abort", resolve)));
          ros.service("/slow", "std_srvs/srv/Trigger").serve(() => new Promise(() => {}));
          const node = ros.node("/dashboard");
          const goal = await node.action("/slow").send({ order: 1 });
          const silent = node.topic("/silent", "std_msgs/msg/UInt8");
          const events = node.events();
          const timeout = Infinity;
          const waiting = {
            messages: silent.messages().next(),
            next: silent.next(),
            untyped: node.topic("/unknown").messages().next(),
            changes: node.parameters("/none").changes().next(),
            follow: node.tf.follow("map", "base").next(),
            feedback: goal.feedback().next(),
            result: goal.result(),
            lookup: node.tf.lookup("map", "base", { timeout }),
            wait: node.service("/nobody", "std_srvs/srv/Trigger").wait(),
            call: node.service("/slow").call({}, { timeout }),
            events: (async () => { for await (const _ of events); return { done: true }; })(),
          };
          // The call has been sent: its client is in the graph.
          for await (const { kind, name } of ros.events()) {
            if (kind === "client" && name === "/slow") break;
          }
          node.close();
          const after = [silent.messages().next(), node.tf.lookup("map", "base")];
          const ended = Object.entries(waiting).map(async ([name, one]) => [name, await told(one)]);
          return [Object.fromEntries(await Promise.all(ended)),
            await Promise.all(after.map(told))];
        }"""
    )
    assert found == [
        {
            "messages": True,
            "next": "closed",
            "untyped": True,
            "changes": True,
            "follow": True,
            "feedback": True,
            "result": "closed",
            "lookup": "closed",
            "wait": "closed",
            "call": "closed",
            "events": True,
        },
        [True, "closed"],
    ]


def test_the_node_of_the_page_stays(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          const topic = ros.topic("/still", "std_msgs/msg/UInt8");
          const next = topic.next();
          ros.node("/other").close();
          ros.close();
          topic.publish({ data: 5 });
          return (await next).data;
        }"""
    )
    assert found == 5
