"""The time of ROS in scripts: timers follow /clock where they should."""

from __future__ import annotations

from playwright.sync_api import Page

# Publishes times on /clock, each after the one before has arrived.
CLOCK = """() => {
  const clock = ros.topic("/clock", "rosgraph_msgs/msg/Clock", { depth: 1 });
  clock.advertise();
  const heard = ros.topic("/clock", "rosgraph_msgs/msg/Clock").messages();
  globalThis.clock = clock;
  globalThis.become = async (...times) => {
    for (const ms of times) {
      clock.publish({ clock: { sec: Math.floor(ms / 1000), nanosec: ms % 1000 * 1e6 } });
      await heard.next();
      // Those who asked after this loop are told by the same task.
      await new Promise((resolve) => setTimeout(resolve));
    }
  };
}"""


def test_timers_follow_simulated_time(scripted: Page) -> None:
    scripted.evaluate(CLOCK)
    found = scripted.evaluate(
        """async () => {
          const node = ros.node("/sim", { parameters: { use_sim_time: true } });
          const before = node.now();
          const calls = [];
          await become(10_000);
          const end = node.timer(100, ({ sec, nanosec }) => calls.push(sec * 1000 + nanosec / 1e6));
          await become(10_050, 10_100, 10_150, 10_420, 10_490, 10_500);
          const after = node.now();
          // Into the past: the next call is a period later.
          await become(5000, 5050, 5110);
          end();
          await become(6000);
          return [before, calls, after, node.now()];
        }"""
    )
    # Three periods were missed at once, which is one call.
    assert found == [
        {"sec": 0, "nanosec": 0},
        [10_100, 10_420, 10_500, 5110],
        {"sec": 10, "nanosec": 500_000_000},
        {"sec": 6, "nanosec": 0},
    ]


def test_a_node_uses_simulated_time_when_its_parameter_says_so(scripted: Page) -> None:
    scripted.evaluate(CLOCK)
    found = scripted.evaluate(
        """async () => {
          const node = ros.node("/sim");
          await become(7000);
          const real = node.now().sec;
          const asleep = node.sleep(60_000).then(() => "woke up");
          await ros.parameters("/sim").set("use_sim_time", true);
          await become(7000, 8000);
          const simulated = node.now().sec;
          await become(7000 + 60_000, 7000 + 120_000);
          await ros.parameters("/sim").set("use_sim_time", false);
          return [real > 1e9, simulated, await asleep, node.now().sec > 1e9];
        }"""
    )
    assert found == [True, 8, "woke up", True]


def test_the_page_has_the_time_of_its_panels(scripted: Page) -> None:
    scripted.evaluate(CLOCK)
    found = scripted.evaluate(
        """async () => {
          ros.now();
          await become(5000);
          const simulated = ros.now();
          const ticks = ros.ticks(1000);
          await become(6000, 7000, 8000);
          // The loop was busy: only the newest is left.
          const { value } = await ticks.next();
          clock.unadvertise();
          for await (const { change, name } of ros.events()) {
            if (change === "gone" && name === "/clock") break;
          }
          return [simulated.sec, value.sec, ros.now().sec > 1e9];
        }"""
    )
    assert found == [5, 8, True]


def test_timers_of_real_time_end_with_their_signal_or_node(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          const told = ({ message }) => message;
          const node = ros.node("/timed");
          const stop = new AbortController();
          const { signal } = stop;
          let calls = 0;
          const called = new Promise((resolve) => node.timer(1, () => {
            if (++calls === 5) { stop.abort(new Error("enough")); resolve(); }
          }, { signal }));
          const asleep = node.sleep(60_000, { signal }).catch(told);
          const begun = node.now();
          await called;
          for await (const { sec } of node.ticks(1)) if (sec >= begun.sec) break;
          const ticks = node.ticks(60_000).next();
          const closing = node.sleep(60_000).catch(told);
          const after = calls;
          node.timer(1, () => { calls += 1; });
          node.close();
          await ros.sleep(20);
          const wrong = [0, -1, Infinity, NaN, undefined].map((period) => {
            try { ros.timer(period, () => {}); } catch (error) { return error.message; }
          });
          return [after, calls, await asleep, (await ticks).done, await closing,
            await node.sleep(1).catch(told), await ros.sleep(0), new Set(wrong).size, wrong[0]];
        }"""
    )
    assert found == [
        *(5, 5, "enough", True, "closed", "closed", None, 1),
        "a period must be a positive number of ms",
    ]
