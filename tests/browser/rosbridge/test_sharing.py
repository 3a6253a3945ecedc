"""Several objects of roslib for the same name, in one connection."""

from __future__ import annotations

from playwright.sync_api import Page


def test_topics_are_listed_while_they_are_advertised(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const listed = async () => (await until((resolve) =>
            link.getTopics(resolve))).topics.includes("/mine");
          const mine = link.Topic({ name: "/mine", messageType: "std_msgs/String" });
          const states = [await listed()];
          mine.advertise();
          states.push(await listed());
          mine.unadvertise();
          return [...states, await listed()];
        }"""
    )
    assert found == [False, True, False]


def test_topics_of_the_same_name_end_by_themselves(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const options = { name: "/mine", messageType: "std_msgs/String" };
          const [one, other] = [link.Topic(options), link.Topic(options)];
          const heard = [];
          const hear = (topic, name) =>
            topic.subscribe(({ data }) => heard.push(`${name} ${data}`));
          const last = link.Topic({ name: "/last", messageType: "std_msgs/String" });
          const publish = async (topic, data) => {
            topic.publish({ data });
            // What was published later comes later.
            await until((resolve) => { last.subscribe(resolve); last.publish({ data }); });
            last.unsubscribe();
          };
          hear(one, "one");
          hear(other, "other");
          await publish(one, "both");
          one.unsubscribe();
          await publish(one, "second");
          other.unadvertise();
          await publish(one, "third");
          other.unsubscribe();
          link.on("/mine", () => heard.push("after the end"));
          await publish(one, "fourth");
          return heard;
        }"""
    )
    assert sorted(found[:2]) == ["one both", "other both"]
    assert found[2:] == ["other second", "other third"]


def test_services_are_advertised_again(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const options = { name: "/mine", serviceType: "std_srvs/Trigger" };
          const server = link.Service(options);
          const serve = (message) => server.advertise((_, response) => {
            Object.assign(response, { success: true, message });
            return true;
          });
          const call = () => until((resolve) => link.Service(options).callService({},
            ({ message }) => resolve(message), resolve));
          await serve("first");
          const told = [await call()];
          await serve("second");
          told.push(await call());
          await Promise.all([server.unadvertise(), serve("third"), server.unadvertise(),
            serve("fourth")]);
          told.push(await call());
          await server.unadvertise();
          await server.unadvertise();
          return [...told, await call(), ros.services().some(({ name }) => name === "/mine")];
        }"""
    )
    assert found == ["first", "second", "fourth", "there is no service /mine", False]


def test_all_goals_are_canceled_and_the_former_type_is_understood(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const action = new ROSLIB.Action({ ros: link, name: "/fibonacci",
            actionType: "action_tutorials_interfaces/action/Fibonacci" });
          const steps = [];
          const run = (order) => until((resolve) => action.sendGoal({ order },
            ({ sequence }) => resolve(sequence.length),
            ({ sequence }) => steps.push(sequence.length),
            (error) => resolve(error.split(":")[1])));
          const done = await run(5);
          const goals = [run(10_000), run(10_000)];
          // roslib gives this call no id, and complains that the response has none.
          console.error = () => {};
          action.cancelAllGoals();
          return { done, steps: steps.slice(0, 4), canceled: await Promise.all(goals) };
        }"""
    )
    assert found == {"done": 6, "steps": [3, 4, 5, 6], "canceled": [" Action was canceled"] * 2}
