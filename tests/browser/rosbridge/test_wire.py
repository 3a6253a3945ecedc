"""What travels as texts and bytes: compressions and fragments, decoded by roslib's own code."""

from __future__ import annotations

from playwright.sync_api import Page

COMPRESSED = """async (compression) => {
  const types = { "/bytes": "sensor_msgs/CompressedImage",
    "/floats": "std_msgs/Float64MultiArray", "/long": "std_msgs/Int64" };
  const sent = {
    "/bytes": { format: "raw", data: "AAEC/w==" }, "/floats": { data: [1.5, null] },
      "/long": { data: 2 ** 40 },
  };
  const other = await wired();
  seen.length = 0;
  const shown = (value) => JSON.stringify(value, (_, one) => (typeof one === "bigint" ? `${one}n`
    : ArrayBuffer.isView(one) ? [one.constructor.name, ...one].map(String) : one));
  const heard = {};
  for (const [name, messageType] of Object.entries(types)) {
    const options = { name, messageType };
    const one = await until((resolve) => {
      other.Topic({ ...options, compression }).subscribe(resolve);
      // The other connection is served at once, this one after its message has come.
      other.Service({ name: "/rosapi/get_time", serviceType: "" }).callService({}, () =>
        link.Topic(options).publish(sent[name]));
    });
    delete one.header;
    delete one.layout;
    heard[name] = compression === "cbor-raw" ? [one.bytes.constructor.name, typeof one.secs,
      one.bytes.length] : shown(one);
  }
  return { heard, ops: [...new Set(seen)] };
}"""


def test_json(page: Page) -> None:
    found = page.evaluate(COMPRESSED, "none")
    assert found["ops"] == ["service_response", "publish"]
    assert found["heard"] == {
        "/bytes": '{"format":"raw","data":"AAEC/w=="}',
        "/floats": '{"data":[1.5,null]}',
        "/long": '{"data":1099511627776}',
    }


def test_png(page: Page) -> None:
    found = page.evaluate(COMPRESSED, "png")
    assert found["ops"] == ["service_response", "png"]
    assert found["heard"] == page.evaluate(COMPRESSED, "none")["heard"]


def test_cbor(page: Page) -> None:
    found = page.evaluate(COMPRESSED, "cbor")
    assert found["ops"] == ["service_response", "bytes"]
    assert found["heard"] == {
        "/bytes": '{"format":"raw","data":["Uint8Array","0","1","2","255"]}',
        "/floats": '{"data":["Float64Array","1.5","NaN"]}',
        "/long": '{"data":1099511627776}',
    }


def test_cbor_raw(page: Page) -> None:
    found = page.evaluate(COMPRESSED, "cbor-raw")
    assert found["ops"] == ["service_response", "bytes"]
    # With the encapsulation header of CDR.
    assert found["heard"]["/long"] == ["Uint8Array", "number", 12]


def test_cbor_comes_as_objects_without_a_socket(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const options = { name: "/floats", messageType: "std_msgs/Float32MultiArray" };
          const message = await until((resolve) => {
            link.Topic({ ...options, compression: "cbor" }).subscribe(resolve);
            link.Topic(options).publish({ data: [1.5] });
          });
          return [message.data.constructor.name, ...message.data];
        }"""
    )
    assert found == ["Float32Array", 1.5]


def test_fragments_travel_both_ways(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const other = await wired();
          const data = "ä€😀".repeat(100);
          const heard = until((resolve) => other.on("/long_text", ({ msg }) => resolve(msg.data)));
          other.callOnConnection({ op: "subscribe", topic: "/long_text", type: "std_msgs/String",
            fragment_size: 50 });
          const text = JSON.stringify({ op: "publish", topic: "/long_text", msg: { data } });
          other.callOnConnection({ op: "advertise", topic: "/long_text", type: "std_msgs/String" });
          const parts = text.match(/[^]{1,40}/g);
          const order = [...parts.keys()].reverse();
          for (const num of order) {
            other.callOnConnection({ op: "fragment", id: "mine", data: parts[num], num,
              total: parts.length });
          }
          return { same: (await heard) === data, fragments: seen.filter((op) =>
            op === "fragment").length > 5 };
        }"""
    )
    assert found == {"same": True, "fragments": True}


def test_programs_that_know_only_an_address_work(page: Page) -> None:
    found = page.evaluate(
        """async () => {
          const undo = rosbridge.serveWebSocket("ws://localhost:9090");
          const other = new ROSLIB.Ros({ url: "ws://localhost:9090" });
          const listener = new ROSLIB.Topic({
            ros: other, name: "/latched", messageType: "std_msgs/String", compression: "cbor",
          });
          const { data } = await until((resolve) => listener.subscribe(resolve));
          const adder = new ROSLIB.Service({
            ros: other, name: "/add_two_ints", serviceType: "example_interfaces/AddTwoInts",
          });
          const { sum } = await until((resolve) => adder.callService({ a: 1, b: 2 }, resolve));
          undo();
          return [data, sum, other.isConnected, /native code/.test(String(WebSocket))];
        }"""
    )
    assert found == ["once", 3, True, True]
