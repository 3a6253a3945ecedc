"""A LEGO Move Hub for tests: the browser's own Bluetooth emulation, with what the hub would say."""

from __future__ import annotations

import base64
from dataclasses import dataclass, field
from typing import Any

from playwright.sync_api import Browser, CDPSession, Page

# With letters they would have to be capitals.
ADDRESS = "09:09:09:09:09:09"
SERVICE = "00001623-1212-efde-1623-785feabcde23"
CHARACTERISTIC = "00001624-1212-efde-1623-785feabcde23"
# Notifications are switched on by a descriptor of this kind.
CONFIGURATION = "00002902-0000-1000-8000-00805f9b34fb"
PROPERTIES = {"write": True, "writeWithoutResponse": True, "notify": True}
# Keeps the characteristic that the page listens to, and notes what the page writes, and when.
HEAR = """if (window.isSecureContext) {
  const { prototype } = BluetoothRemoteGATTCharacteristic;
  const { startNotifications, writeValueWithoutResponse } = prototype;
  prototype.startNotifications = function () {
    window.heard = this;
    return startNotifications.call(this);
  };
  window.written = [];
  prototype.writeValueWithoutResponse = function (message) {
    written.push([performance.now(), [...message]]);
    return writeValueWithoutResponse.call(this, message);
  };
}"""


@dataclass
class MoveHub:
    """A hub in reach of the browser; `messages` is every message that it got, as hexadecimal."""

    tab: Page
    browser: CDPSession
    page: CDPSession
    messages: list[str] = field(default_factory=list)
    characteristic: str = ""
    connections: int = 0
    answers: bool = True
    chosen: bool = True
    _answered: set[str] = field(default_factory=set)

    def disappear(self) -> None:
        """End the connection, as when its battery is taken out."""
        self.browser.send("BluetoothEmulation.simulateGATTDisconnection", {"address": ADDRESS})

    def say(self, message: str) -> None:
        """Send a message, given as hexadecimal; the emulation itself has no notifications."""
        self.tab.evaluate(
            """(bytes) => {
              const value = new DataView(Uint8Array.from(bytes).buffer);
              Object.defineProperty(heard, "value", { value, configurable: true });
              heard.dispatchEvent(new Event("characteristicvaluechanged"));
            }""",
            list(bytes.fromhex(message)),
        )

    def switch_off(self) -> None:
        """End the emulation, after the page that uses it: the other order crashes the browser."""
        self.tab.goto("about:blank")
        self.browser.send("BluetoothEmulation.disable")
        self.browser.detach()

    def take(self) -> list[str]:
        """Return the messages since the last time."""
        messages, self.messages[:] = list(self.messages), []
        return messages

    def written(self) -> list[tuple[float, str]]:
        """Return all that the page has written, each with the page's time in ms."""
        found = self.tab.evaluate("written")
        return [(time, bytes(message).hex(" ")) for time, message in found]

    def _connected(self, event: dict[str, Any]) -> None:
        self.connections += event["type"] == "connection"
        code = 0 if self.answers else 0x3E
        answer = {"address": event["address"], "type": event["type"], "code": code}
        self.browser.send("BluetoothEmulation.simulateGATTOperationResponse", answer)

    def _called(self, event: dict[str, Any]) -> None:
        if event["type"] == "write":
            self.messages.append(base64.b64decode(event["data"]).hex(" "))
        answer = {"characteristicId": event["characteristicId"], "type": event["type"], "code": 0}
        self.browser.send("BluetoothEmulation.simulateCharacteristicOperationResponse", answer)

    def _prompted(self, event: dict[str, Any]) -> None:
        # It tells again whenever the list grows.
        if not event["devices"] or event["id"] in self._answered:
            return
        self._answered.add(event["id"])
        if not self.chosen:
            self.page.send("DeviceAccess.cancelPrompt", {"id": event["id"]})
            return
        device = event["devices"][0]["id"]
        self.page.send("DeviceAccess.selectPrompt", {"id": event["id"], "deviceId": device})


def move_hub(browser: Browser, page: Page) -> MoveHub:
    """Switch on a Move Hub beside the browser."""
    session = browser.new_browser_cdp_session()
    page.add_init_script(HEAR)
    hub = MoveHub(page, session, page.context.new_cdp_session(page))
    session.send("BluetoothEmulation.enable", {"state": "powered-on", "leSupported": True})
    session.on("BluetoothEmulation.gattOperationReceived", hub._connected)
    session.on("BluetoothEmulation.characteristicOperationReceived", hub._called)
    about = {"name": "Move Hub", "manufacturerData": [], "knownServiceUuids": [SERVICE]}
    session.send("BluetoothEmulation.simulatePreconnectedPeripheral", {"address": ADDRESS, **about})
    service = session.send(
        "BluetoothEmulation.addService", {"address": ADDRESS, "serviceUuid": SERVICE}
    )
    characteristic = session.send(
        "BluetoothEmulation.addCharacteristic",
        {
            "serviceId": service["serviceId"],
            "characteristicUuid": CHARACTERISTIC,
            "properties": PROPERTIES,
        },
    )
    hub.characteristic = characteristic["characteristicId"]
    descriptor = {"characteristicId": hub.characteristic, "descriptorUuid": CONFIGURATION}
    session.send("BluetoothEmulation.addDescriptor", descriptor)
    hub.page.send("DeviceAccess.enable")
    hub.page.on("DeviceAccess.deviceRequestPrompted", hub._prompted)
    return hub
