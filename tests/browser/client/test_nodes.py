"""Nodes that a script makes are nodes of ROS: with a name, a log and parameters."""

from __future__ import annotations

from browser import Built, Serve
from paths import SITES
from playwright.sync_api import ConsoleMessage, Page

# Declares what the node /robot in C++ does.
ALIKE = """() => {
  const node = ros.node("/mine");
  node.declare("speed", 1.5);
  node.declare("count", 3);
  node.declare("label", "first");
  node.declare("robot.name", "r2", { readOnly: true });
  node.declare("robot.limits.linear", 0.5,
    { description: "in m/s", min: -1, max: 1.5, step: 0.25 });
  node.declare("robot.limits.gears", 4, { min: 1, max: 10, step: 3 });
  node.declare("anything", [1.5, 2.5], { dynamic: true }).value = new Float64Array([1, 2.5]);
}"""


def test_a_node_has_what_nodes_of_ros_have(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          const log = ros.topic("/rosout", "rcl_interfaces/msg/Log").messages();
          const node = ros.node("fleet/driver");
          node.log.info("ready");
          node.log.debug("not said");
          node.log.level = "debug";
          node.log.debug("said");
          node.log.warn({ toString: () => "an object" });
          const lines = [];
          for await (const { level, name, msg } of log) {
            if (lines.push([level, name, msg]) === 3) break;
          }
          const services = ros.services().filter(({ servers }) => servers.includes(node.name));
          const publishing = ros.topics()
            .filter(({ publishers }) => publishers.includes(node.name));
          let odd = "";
          try { node.log.level = "loud"; } catch (error) { odd = error.message; }
          return {
            lines, name: node.name, nodes: ros.nodes(), odd,
            services: services.map(({ name, types }) => [name, ...types]),
            publishing: publishing.map(({ name }) => name),
          };
        }"""
    )
    names = (
        ("describe_parameters", "DescribeParameters"),
        ("get_parameter_types", "GetParameterTypes"),
        ("get_parameters", "GetParameters"),
        ("list_parameters", "ListParameters"),
        ("set_parameters", "SetParameters"),
        ("set_parameters_atomically", "SetParametersAtomically"),
    )
    assert found == {
        "lines": [
            [20, "fleet.driver", "ready"],
            [10, "fleet.driver", "said"],
            [30, "fleet.driver", "an object"],
        ],
        "name": "/fleet/driver",
        "nodes": ["/fleet/driver"],
        "odd": "unknown log level 'loud'; known are debug, info, warn, error, fatal",
        "services": [
            [f"/fleet/driver/{name}", f"rcl_interfaces/srv/{kind}"] for name, kind in names
        ],
        "publishing": ["/parameter_events", "/rosout"],
    }


def test_names_are_relative_to_the_namespace_of_a_node(scripted: Page) -> None:
    found = scripted.evaluate(
        """() => {
          const node = ros.node("/fleet/r1/driver");
          const names = ["speed", "~/speed", "/speed", "~"].map((name) => node.topic(name).name);
          const other = node.node("arm");
          return [...names, other.name, other.parameters("driver").node, ros.topic("speed").name,
            ros.node("alone").topic("speed").name];
        }"""
    )
    assert found == [
        "/fleet/r1/speed",
        "/fleet/r1/driver/speed",
        "/speed",
        "/fleet/r1/driver",
        "/fleet/r1/arm",
        "/fleet/r1/driver",
        "/speed",
        "/speed",
    ]


def test_two_nodes_with_one_name_are_told(scripted: Page) -> None:
    warnings: list[str] = []

    def note(message: ConsoleMessage) -> None:
        if message.type == "warning":
            warnings.append(message.text)

    scripted.on("console", note)
    scripted.evaluate(
        """() => {
          ros.node("first").close();
          ros.node("first");
          ros.node("/first");
        }"""
    )
    assert warnings == [
        "there is another node with the name /first; "
        "ROS cannot tell their parameters and logs apart"
    ]


def test_parameters_answer_as_those_of_a_node_in_cpp(tab: Page, serve: Serve, built: Built) -> None:
    tab.goto(serve(built(SITES / "scripts")))
    tab.wait_for_selector("body[data-scripted]")
    tab.evaluate("() => ros.action('/fibonacci').wait()")
    tab.evaluate(ALIKE)
    cpp, ours = tab.evaluate(
        """async () => {
          const SRV = "rcl_interfaces/srv";
          const value = (type, field, plain) => ({ type, [field]: plain });
          const double = (plain) => value(3, "double_value", plain);
          const integer = (plain) => value(2, "integer_value", plain);
          const text = (plain) => value(4, "string_value", plain);
          const set = (...parameters) => ["set_parameters", "SetParameters",
            { parameters: parameters.map(([name, value]) => ({ name, value })) }];
          const atomically = (...given) =>
            ["set_parameters_atomically", "SetParametersAtomically", set(...given)[2]];
          const list = (prefixes, depth) =>
            ["list_parameters", "ListParameters", { prefixes, depth }];
          const get = (...names) => ["get_parameters", "GetParameters", { names }];
          const questions = [
            ["speed", double(-0.25)], ["speed", integer(2n)], ["count", integer(7n)],
            ["count", double(1)], ["label", text("second")], ["none", text("x")],
            ["robot.name", text("x")], ["robot.limits.linear", double(1.5)],
            ["robot.limits.linear", double(1.3)],
            ["robot.limits.linear", double(-1.25)], ["robot.limits.gears", integer(7n)],
            ["robot.limits.gears", integer(8n)], ["robot.limits.gears", integer(11n)],
            ["anything", text("now a text")], ["label", { type: 0 }],
          ].map((one) => set(one)).concat([
            set(["speed", double(1)], ["count", text("no")], ["label", text("third")]),
            atomically(["speed", double(9)], ["count", text("no")]),
            atomically(["speed", double(9)], ["none", text("no")]),
            atomically(["none", text("no")]),
            atomically(["speed", double(4)], ["label", text("fourth")]),
            get("speed", "count", "label", "anything", "robot.limits.linear", "robot.limits.gears"),
            get("speed", "none"), get(),
            ["get_parameter_types", "GetParameterTypes",
              { names: ["speed", "anything", "robot.name"] }],
            ["describe_parameters", "DescribeParameters",
              { names: ["robot.name", "robot.limits.linear", "robot.limits.gears", "anything"] }],
            list([], 0n), list([], 1n), list([], 2n), list(["robot"], 0n), list(["robot"], 1n),
            list(["robot.limits", "speed"], 1n), list(["none"], 0n),
            set(["anything", { type: 0 }]), list([], 0n),
          ]);
          const plain = (_, one) => typeof one === "bigint" ? `${one}n`
            : ArrayBuffer.isView(one) ? [...one] : one;
          const sorted = ({ result, ...rest }) => JSON.parse(JSON.stringify(result?.names ? {
            names: result.names.filter((name) => !name.startsWith("qos_overrides")).sort(),
            prefixes: result.prefixes.filter((name) => !name.startsWith("qos_overrides")).sort(),
          } : { ...rest, ...result }, plain));
          const asked = async (name) => {
            const answers = [];
            for (const [service, type, request] of questions) {
              answers.push([JSON.stringify([service, request], plain),
                sorted(await ros.service(`${name}/${service}`, `${SRV}/${type}`).call(request))]);
            }
            return answers;
          };
          return [await asked("/robot"), await asked("/mine")];
        }"""
    )
    assert len(cpp) == 34
    for theirs, mine in zip(cpp, ours, strict=True):
        assert mine == theirs


def test_a_script_declares_parameters_and_hears_of_changes(scripted: Page) -> None:
    found = scripted.evaluate(
        """async () => {
          const node = ros.node("/mine", { parameters: { speed: 2, use_sim_time: false } });
          const events = ros.topic("/parameter_events").messages();
          const speed = node.declare("speed", 0.5, { max: 3.5 });
          const label = node.declare("label", "a", {
            accept: (value) => value.length < 4 || "too long",
          });
          const heard = speed.changes();
          const before = speed.value;
          speed.value = 3;
          const others = ros.parameters("/mine");
          await others.set({ speed: 1, label: "abc" });
          const refusals = [
            await others.set("label", "abcd").catch(({ message }) => message),
            await others.set("speed", 4).catch(({ message }) => message),
          ];
          for (const wrong of [9, "fast"]) {
            try { speed.value = wrong; } catch ({ message }) { refusals.push(message); }
          }
          const told = [(await heard.next()).value, (await heard.next()).value];
          const all = await others.all();
          const own = await node.parameters("mine").get("speed");
          const { type } = await others.describe("speed");
          label.undeclare();
          const later = node.declare("later", undefined, { type: "integer" });
          const unset = later.value;
          later.value = 5;
          const heardOf = [];
          const names = (list) => list.map(({ name }) => name).join();
          for await (const one of events) {
            if (one.node !== "/mine") continue;
            heardOf.push([names(one.new_parameters), names(one.changed_parameters),
              names(one.deleted_parameters)]);
            if (names(one.new_parameters) === "later") break;
          }
          const left = [...node.declared.keys()];
          return { before, refusals, told, all, own, type, heardOf, left, unset };
        }"""
    )
    wrong = "parameter {speed} is of type {double}, setting it to {string} is not allowed."
    assert found == {
        "before": 2,
        "refusals": [
            "/mine refused: too long",
            "/mine refused: Parameter {speed} doesn't comply with floating point range.",
            "/mine refused: Parameter {speed} doesn't comply with floating point range.",
            f"/mine refused: Wrong parameter type, {wrong}",
        ],
        "told": [3, 1],
        "all": {"use_sim_time": False, "speed": 1, "label": "abc"},
        "own": 1,
        "type": 3,
        "heardOf": [
            ["speed", "", ""],
            ["label", "", ""],
            ["", "speed", ""],
            ["", "speed,label", ""],
            ["", "", "label"],
            ["later", "", ""],
        ],
        "left": ["use_sim_time", "speed", "later"],
        "unset": None,
    }


def test_wrong_declarations_are_errors(scripted: Page) -> None:
    found = scripted.evaluate(
        """() => {
          const node = ros.node("/mine");
          node.declare("twice", 1);
          node.declare("later", undefined, { type: "string_array" });
          const fault = (act) => { try { act(); } catch ({ message }) { return message; } };
          const closed = ros.node("/gone");
          closed.close();
          return [
            fault(() => node.declare("twice", 1)), fault(() => node.declare("none")),
            fault(() => node.declare("", 1)), fault(() => node.declare("a", 1, { unit: "m" })),
            fault(() => node.declare("a", 1, { type: "float" })),
            fault(() => node.declare("a", "text", { min: 1 })),
            fault(() => node.declare("a", 9, { max: 3 })),
            fault(() => node.declare("a", 0.5, { type: "integer" })),
            fault(() => node.declare("a", { x: 1 })), fault(() => node.declare("a", 2n ** 63n)),
            fault(() => ros.declare("a", 1)), fault(() => closed.declare("a", 1)),
            fault(() => ros.node("/sim", { parameters: { use_sim_time: "yes" } })),
            [...node.declared.keys()], ros.nodes(),
          ];
        }"""
    )
    double = "Wrong parameter type, parameter {a} is of type {integer}, setting it to {double}"
    text = "Wrong parameter type, parameter {use_sim_time} is of type {bool}, "
    text += "setting it to {string}"
    known = "type, description, constraints, readOnly, dynamic, min, max, step, accept"
    types = "bool, integer, double, string, byte_array, bool_array, integer_array, double_array"
    assert found == [
        "parameter 'twice' has already been declared",
        "none: a parameter needs a value or a type",
        "a parameter needs a name, which is a text",
        f"a: unknown option 'unit'; known are {known}",
        f"a: unknown type 'float'; known are {types}, string_array",
        "a: only integers and doubles can have a range",
        "/mine refused: Parameter {a} doesn't comply with integer range.",
        f"/mine refused: {double} is not allowed.",
        "a parameter is a boolean, a number, a text, or a list of one of these",
        "9223372036854775808 does not fit into 64 bits",
        "the page itself has no parameters; make a node with ros.node()",
        "closed",
        f"/sim refused: {text} is not allowed.",
        ["use_sim_time", "twice", "later"],
        ["/mine"],
    ]
