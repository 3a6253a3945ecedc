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
    assert full["/chatter"] == "string data"
    assert "\nMSG: geometry_msgs/TransformStamped\nstd_msgs/Header header\n" in full["/tf"]
    assert found["decoded"]["pose"]["orientation"] == dict.fromkeys("xyz", "double") | {
        "w": "double"
    }
    assert found["publishers"] == ["/robot"]


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
    assert "error" in ask(page, "message_details", type="no_msgs/None")
    assert ask(page, "nonsense") == {"error": "there is no service /rosapi/nonsense"}
