"""The services of rosapi, as roslib asks for them."""

from __future__ import annotations

from typing import Any

from playwright.sync_api import Page

ASK = """async ([name, request]) => until((resolve) =>
  link.Service({ name: `/rosapi/${name}`, serviceType: "" }).callService(request, resolve,
    (error) => resolve({ error })))"""


def ask(page: Page, service: str, /, **request: Any) -> Any:
    return page.evaluate(ASK, [service, request])


def test_the_methods_of_roslib(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const all = {};
          const ask = async (name, ...given) => {
            all[name] = await until((resolve, reject) => link[name](...given, resolve, reject));
          };
          await ask("getTopics");
          await ask("getTopicsForType", "std_msgs/String");
          await ask("getTopicType", "/chatter");
          await ask("getServices");
          await ask("getServicesForType", "example_interfaces/srv/AddTwoInts");
          await ask("getServiceType", "/add_two_ints");
          await ask("getServiceRequestDetails", "example_interfaces/AddTwoInts");
          await ask("getServiceResponseDetails", "std_srvs/srv/SetBool");
          await ask("getNodes");
          await ask("getNodeDetails", "/robot");
          await ask("getActionServers");
          await ask("getTopicsAndRawTypes");
          await ask("getMessageDetails", "geometry_msgs/PoseStamped");
          all.decoded = link.decodeTypeDefs(all.getMessageDetails);
          const topic = link.Topic({ name: "/chatter", messageType: "std_msgs/String" });
          all.publishers = await until((resolve) => topic.getPublishers(resolve));
          return all;
        }"""
    )
    topics = found["getTopics"]
    assert dict(zip(topics["topics"], topics["types"], strict=True))["/chatter"] == (
        "std_msgs/msg/String"
    )
    assert not any("/_" in name for name in topics["topics"])
    assert {"/chatter", "/latched", "/echo"} <= set(found["getTopicsForType"])
    assert found["getTopicType"] == "std_msgs/msg/String"
    assert {"/add_two_ints", "/robot/get_parameters", "/rosapi/topics"} <= set(found["getServices"])
    assert found["getServicesForType"] == ["/add_two_ints"]
    assert found["getServiceType"] == "example_interfaces/srv/AddTwoInts"
    assert found["getServiceRequestDetails"]["typedefs"] == [
        {
            "type": "example_interfaces/AddTwoInts_Request",
            "fieldnames": ["a", "b"],
            "fieldtypes": ["int64", "int64"],
            "fieldarraylen": [-1, -1],
            "examples": ["0", "0"],
            "constnames": [],
            "constvalues": [],
        }
    ]
    [response] = found["getServiceResponseDetails"]["typedefs"]
    assert response["fieldtypes"] == ["boolean", "string"]
    assert {"/robot", "/rosbridge", "/rosapi"} <= set(found["getNodes"])
    details = found["getNodeDetails"]
    assert "/chatter" in details["publishing"]
    assert "/echo" in details["subscribing"]
    assert "/add_two_ints" in details["services"]
    assert found["getActionServers"] == ["/fibonacci"]
    raw = found["getTopicsAndRawTypes"]
    full = dict(zip(raw["topics"], raw["typedefs_full_text"], strict=True))
    assert full["/chatter"].startswith("# This was originally provided as an example message.\n")
    assert full["/chatter"].endswith("\n\nstring data\n")
    assert "\ngeometry_msgs/TransformStamped[] transforms\n\n=====" in full["/tf"]
    assert "\nMSG: geometry_msgs/TransformStamped\n# This expresses a transform" in full["/tf"]
    assert "float64 z 0\nfloat64 w 1\n" in full["/tf"]
    headings = [line for line in full["/tf"].splitlines() if line.startswith("MSG: ")]
    names = ["TransformStamped", "Transform", "Quaternion", "Vector3"]
    assert headings == [
        *(f"MSG: geometry_msgs/{name}" for name in names),
        "MSG: std_msgs/Header",
        "MSG: builtin_interfaces/Time",
    ]
    assert found["decoded"]["pose"]["orientation"] == dict.fromkeys("xyz", "double") | {
        "w": "double"
    }
    assert found["publishers"] == ["/robot"]


def test_definitions_without_files_have_no_comments(page: Page) -> None:
    page.context.route("**/interfaces/*.json", lambda route: route.fulfill(json={}))
    raw = ask(page, "topics_and_raw_types")
    full = dict(zip(raw["topics"], raw["typedefs_full_text"], strict=True))
    assert full["/chatter"] == "string data\n"
    assert "\nMSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\n" in full["/tf"]
    assert "float64 z 0.0\nfloat64 w 1.0\n" in full["/tf"]


def test_further_services(page: Page) -> None:
    assert ask(page, "subscribers", topic="/echo") == {"subscribers": ["/robot"]}
    assert ask(page, "service_node", service="/add_two_ints") == {"node": "/robot"}
    assert ask(page, "service_providers", service="example_interfaces/AddTwoInts") == {
        "providers": ["/robot"]
    }
    assert ask(page, "action_type", action="/fibonacci") == {
        "type": "example_interfaces/action/Fibonacci"
    }
    [goal] = ask(page, "action_goal_details", type="example_interfaces/Fibonacci")["typedefs"]
    assert goal["fieldnames"] == ["order"]
    [first, second] = ask(page, "service_typedescs", type="std_srvs/Trigger")["typedefs"]
    assert (first["fieldnames"], second["fieldnames"]) == ([], ["success", "message"])
    assert ask(page, "has_param", name="/robot:label") == {"exists": True}
    assert ask(page, "has_param", name="/robot:other") == {"exists": False}
    assert ask(page, "get_param", name="/robot:other", default_value='"x"')["value"] == '"x"'
    assert not ask(page, "delete_param", name="/robot:label")["successful"]
    assert ask(page, "get_ros_version")["version"] == 2
    assert ask(page, "get_time")["time"]["sec"] > 1_700_000_000
    interfaces = ask(page, "interfaces")["interfaces"]
    assert {
        "std_msgs/msg/String",
        "std_srvs/srv/Trigger",
        "example_interfaces/action/Fibonacci",
    } <= set(interfaces)
    assert not any(name.endswith(("_Request", "_Feedback")) for name in interfaces)
    assert "error" in ask(page, "service_request_details", type="no_msgs/None")
    assert "error" in ask(page, "message_details", type="None")
    assert ask(page, "nonsense") == {"error": "there is no service /rosapi/nonsense"}


def described(page: Page, type_name: str) -> list[Any]:
    found: list[Any] = ask(page, "message_details", type=type_name)["typedefs"]
    return found


def test_types_are_described_as_rclpy_has_them(page: Page) -> None:
    types = [one["type"] for one in described(page, "geometry_msgs/PoseStamped")]
    assert types == [
        "geometry_msgs/PoseStamped",
        "std_msgs/Header",
        "builtin_interfaces/Time",
        "geometry_msgs/Pose",
        "geometry_msgs/Point",
        "geometry_msgs/Quaternion",
    ]
    [quaternion] = described(page, "geometry_msgs/msg/Quaternion")
    assert quaternion["examples"] == ["0.0", "0.0", "0.0", "1.0"]
    status, value = described(page, "diagnostic_msgs/DiagnosticStatus")
    assert status["fieldtypes"][0] == "octet"
    assert status["examples"] == ["b'\\x00'", "", "", "", "[]"]
    assert status["constnames"] == ["ERROR", "OK", "STALE", "WARN"]
    assert status["constvalues"] == [f"b'\\x0{level}'" for level in (2, 0, 3, 1)]
    assert value["examples"] == ["", ""]
    [covariance] = [
        one for one in described(page, "geometry_msgs/PoseWithCovariance") if "Cov" in one["type"]
    ]
    assert covariance["fieldarraylen"] == [-1, 36]
    assert covariance["examples"] == ["{}", "[]"]
    [time] = described(page, "time")
    assert (time["fieldnames"], time["fieldtypes"]) == (["secs", "nsecs"], ["int32", "int32"])
    [time] = described(page, "builtin_interfaces/Time")
    assert time["fieldnames"] == ["sec", "nanosec"]
    assert described(page, "string") == []
    assert described(page, "no_msgs/None") == []


def test_only_nodes_of_the_graph_have_details(page: Page) -> None:
    assert ask(page, "node_details", node="/none") == {"error": "there is no node '/none'"}
    assert ask(page, "node_details", node=3) == {"error": "'node' is a number; it must be a string"}
    details = ask(page, "node_details", node="/rosapi")
    assert "/rosapi/topics" in details["services"]
    shown = ask(page, "node_details", node="/robot")
    assert not any("/_" in name for names in shown.values() for name in names)
    assert ask(page, "topic_type", topic="/fibonacci/_action/feedback") == {"type": ""}


def test_a_parameter_without_a_node_is_found_in_the_nodes(page: Page) -> None:
    assert ask(page, "get_param", name="label")["value"] == '"first"'
    assert ask(page, "has_param", name="/label") == {"exists": True}
    assert ask(page, "set_param", name="speed", value="7")["successful"]
    assert ask(page, "get_param", name="/robot:speed")["value"] == "7"
    page.evaluate(
        """async () => {
          const serve = (name, type, answer) => link.Service({ name: `/twin/${name}`,
            serviceType: `rcl_interfaces/${type}` }).advertiseAsync(answer);
          await serve("list_parameters", "ListParameters", async () => ({}));
          await serve("get_parameters", "GetParameters", async () =>
            ({ values: [{ type: 4, string_value: "x" }] }));
        }"""
    )
    several = ask(page, "get_param", name="label")["reason"]
    assert several == "/robot, /twin have a parameter 'label'; write '/robot:label'"
    assert ask(page, "get_param", name="/twin:label")["value"] == '"x"'
    assert ask(page, "get_param", name="other")["value"] == '"x"'


def test_a_parameter_that_no_node_has_is_kept(page: Page) -> None:
    assert ask(page, "get_param", name="max_vel_y")["reason"] == "parameter max_vel_y is not set"
    assert ask(page, "get_param", name="max_vel_y", default_value="2")["value"] == "2"
    assert ask(page, "set_param", name="max_vel_y", value="0.5") == {
        "successful": True,
        "reason": "",
    }
    assert ask(page, "get_param", name="/max_vel_y")["value"] == "0.5"
    assert "/max_vel_y" in ask(page, "get_param_names")["names"]
    assert not ask(page, "set_param", name="max_vel_y", value="{")["successful"]
    big = ask(page, "set_param", name="large", value=f'"{"x" * 4_000_000}"')
    assert big["reason"].startswith("parameters without a node have at most")
    assert ask(page, "delete_param", name="max_vel_y")["successful"]
    assert ask(page, "has_param", name="max_vel_y") == {"exists": False}
    assert not ask(page, "delete_param", name="max_vel_y")["successful"]


def test_parameters_are_read_after_they_were_set(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const ask = (service, request) => until((resolve, reject) => link.Service({
            name: `/rosapi/${service}`, serviceType: "" }).callService(request, resolve, reject));
          const asked = [];
          for (let value = 0; value < 20; value++) {
            asked.push(ask("set_param", { name: "/robot:speed", value: String(value) }));
            asked.push(ask("get_param", { name: "speed" }));
          }
          const told = await Promise.all(asked);
          return told.filter((_, index) => index % 2).map(({ value }) => Number(value));
        }"""
    )
    assert found == list(range(20))


def test_a_silent_node_delays_only_requests_about_itself(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          for (const [name, type] of [["list", "ListParameters"], ["get", "GetParameters"]]) {
            await link.Service({ name: `/silent/${name}_parameters`,
              serviceType: `rcl_interfaces/${type}` }).advertiseAsync(() => new Promise(() => {}));
          }
          const done = [];
          const ask = (service, name) => until((resolve, reject) => link.Service({
            name: `/rosapi/${service}`, serviceType: "" }).callService({ name }, (answer) => {
              done.push([service, name, answer.value ?? answer.names.includes("/robot:label")]);
              resolve();
            }, reject));
          await Promise.all([ask("get_param", "/silent:label"), ask("get_param", "/robot:label"),
            ask("get_param", "label"), ask("get_param_names", ""), ask("get_param", "speed")]);
          return done;
        }"""
    )
    speed = ask(page, "get_param", name="/robot:speed")["value"]
    assert found == [
        ["get_param", "/robot:label", '"first"'],
        ["get_param", "label", '"first"'],
        ["get_param_names", "", True],
        ["get_param", "speed", speed],
        ["get_param", "/silent:label", ""],
    ]
