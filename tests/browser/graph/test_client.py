"""The page's own part in the graph: objects in, objects out, through real CDR."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from browser import Scripted, Serve
from scenario import player

pytestmark = [pytest.mark.firefox(always=True), pytest.mark.webkit(always=True)]

SETTING = """
const { Graph } = await import("./page/graph.js");
const { PageClient } = await import("./page/pageClient.js");
const field = (name, type) => ({ name, type });
const type = (...fields) => ({ fields, constants: [] });
const types = {
  "demo/msg/Point": type(field("x", "float64"), field("y", "float64")),
  "demo/msg/All": type(
    field("flag", "bool"), field("small", "int8"), field("big", "int64"), field("ratio", "float32"),
    field("text", "string<=20"), field("pair", "uint16[2]"), field("bytes", "uint8[]"),
    field("names", "string[<=3]"), field("wide", "wstring"), field("wides", "wstring[2]"),
    field("at", "demo/msg/Point"), field("path", "demo/msg/Point[]")),
  "demo/msg/Nothing": type(),
  "demo/srv/Half_Request": type(field("value", "int32")),
  "demo/srv/Half_Response": type(field("half", "float64")),
};
const graph = new Graph();
const client = new PageClient(graph, types);
const other = new PageClient(graph, types);
const plain = (value) => JSON.parse(JSON.stringify(value, (key, one) =>
  typeof one === "bigint" ? `${one}n` : ArrayBuffer.isView(one) ? [...one] : one));
"""


@pytest.fixture
def play(any_tab: Scripted, serve: Serve, tmp_path: Path) -> Any:
    """A function that runs a scenario and returns what it returns."""
    return player(any_tab, serve, tmp_path, SETTING)


def test_messages_of_every_kind_of_field_come_back(play: Any) -> None:
    assert play("""
      const heard = [];
      client.subscribe("/all", "demo/msg/All", (m, info) => heard.push([m, info.size]));
      client.subscribe("/no", "demo/msg/Nothing", (m, info) => heard.push([m, info.size]));
      const all = other.advertise("/all", "demo/msg/All");
      const nothing = other.advertise("/no", "demo/msg/Nothing");
      all.publish({ flag: true, small: -3, big: 9007199254740993n, ratio: 0.5, text: "Grüße",
        pair: [1, 65535], bytes: new Uint8Array([1, 2, 3]), names: ["ä", ""],
        wide: "€ 𝄞", wides: ["b", ""], at: { x: 1, y: -2 }, path: [{ x: 3, y: 4 }] });
      all.publish({});
      nothing.publish({});
      await arrived();
      return plain(heard);
    """) == [
        [
            {
                "flag": True,
                "small": -3,
                "big": "9007199254740993n",
                "ratio": 0.5,
                "text": "Grüße",
                "pair": [1, 65535],
                "bytes": [1, 2, 3],
                "names": ["ä", ""],
                "wide": "€ 𝄞",
                "wides": ["b", ""],
                "at": {"x": 1, "y": -2},
                "path": [{"x": 3, "y": 4}],
            },
            140,
        ],
        [
            {
                "flag": False,
                "small": 0,
                "big": "0n",
                "ratio": 0,
                "text": "",
                "pair": [0, 0],
                "bytes": [],
                "names": [],
                "wide": "",
                "wides": ["", ""],
                "at": {"x": 0, "y": 0},
                "path": [],
            },
            80,
        ],
        [{}, 5],
    ]


def test_what_is_closed_leaves_nothing(play: Any) -> None:
    assert play("""
      const heard = [];
      const end = client.subscribeBytes("/a", "any/msg/Type", (bytes) => heard.push(bytes.length));
      const publisher = other.advertise("/a", "any/msg/Type");
      const during = graph.topics();
      let refused;
      try { publisher.publish({}); } catch (error) { refused = error.message; }
      end();
      publisher.close();
      await arrived();
      return { during, refused, heard, after: graph.endpoints() };
    """) == {
        "during": [
            {
                "name": "/a",
                "types": ["any/msg/Type"],
                "publishers": ["/_page"],
                "subscriptions": ["/_page"],
                "missed": 0,
                "mismatches": [],
            }
        ],
        "refused": "this page has no definition of any/msg/Type",
        "heard": [],
        "after": [],
    }


def test_services_are_promises(play: Any) -> None:
    assert play("""
      const { Participant } = await import("./participant/participant.js");
      const { Codec } = await import("./messages/codec.js");
      const { DEFAULT_QOS } = await import("./protocol.js");
      const codec = new Codec(types);
      const call = (value, timeout) =>
        client.call("/half", "demo/srv/Half", { value }, timeout).catch((error) => error.message);
      const alone = await call(1);
      let server;
      const id = graph.join((message) => server.receive(message), "", () => {});
      server = new Participant(id, (message) => graph.receive(id, message));
      const service = server.create("service", "/server", "/half", "demo/srv/Half", DEFAULT_QOS);
      const answers = [call(7), call(8)];
      await arrived();
      for (let one; (one = server.take(service)); ) {
        const { value } = codec.read("demo/srv/Half_Request", one.message);
        const response = codec.write("demo/srv/Half_Response", { half: value / 2 });
        server.respond(service, one.writer, one.sequence, response);
      }
      server.flush();
      const late = await call(9, 50);
      return { alone, answers: await Promise.all(answers), late };
    """) == {
        "alone": "no server for /half now",
        "answers": [{"half": 3.5}, {"half": 4}],
        "late": "no response from /half within 0.05 s",
    }
