// @ts-check
// A LEGO Move Hub over Web Bluetooth, with the LEGO Wireless Protocol 3.

import { say } from "../../../ui/words.js";
import { obstacle } from "./bluetooth.js";

const SERVICE = "00001623-1212-efde-1623-785feabcde23";
const CHARACTERISTIC = "00001624-1212-efde-1623-785feabcde23";
// Message types. A message begins with its length, a zero and the type.
const PROPERTY = 0x01;
const ATTACHED = 0x04;
const INPUT_FORMAT = 0x41;
const VALUE = 0x45;
const OUTPUT = 0x81;
// Properties of the hub, and the request to report them.
const BUTTON = 0x02;
const BATTERY = 0x06;
const REPORT = 0x02;
// Ports of the hub, and types of sensors, whose ports the hub reports.
const MOTORS = [0x00, 0x01];
const LIGHT = 0x32;
const COLOR_DISTANCE = { type: 0x25, mode: 0x08 };
const TILT = { type: 0x28, mode: 0x00 };
// Execute immediately and report the end; write directly to the device.
const AT_ONCE = 0x11;
const DIRECT = 0x51;
// The shortest time between commands to the motors (ms), because the radio is slow and commands must not queue.
const PACE = 50;
const TRIES = 3;
// The time for the last messages before the connection ends (ms).
const FAREWELL = 500;

/**
 * Reports of a hub: the charge of its battery (%), its button, the distance (m), the tilt (radians), and the loss of
 * the connection.
 * @typedef {{
 *   battery(percent: number): void,
 *   button(pressed: boolean): void,
 *   distance(metres: number): void,
 *   tilt(x: number, y: number): void,
 *   lost(): void,
 * }} Listener
 * @typedef {Awaited<ReturnType<typeof connect>>} MoveHub
 */

/**
 * Let the visitor choose a hub, and connect to it. Browsers allow this only in a click handler. Rejects with an Error
 * that says what went wrong and what to do.
 * @param {Listener} listener
 */
export async function connect(listener) {
  const device = await step(
    navigator.bluetooth?.requestDevice({ filters: [{ services: [SERVICE] }] }),
    say("No hub was chosen. Press the green button on the hub so that its light blinks, then connect again."),
  );
  // Defined first, because an error in any later step must end the connection.
  const closing = new AbortController();
  const disconnect = () => {
    closing.abort();
    device.gatt.disconnect();
  };
  try {
    const server = await step(device.gatt.connect(),
      say("The hub does not respond. Check that it is on, nearby and not connected to another device, then connect again."));
    const service = await step(server.getPrimaryService(SERVICE), say("The chosen device is not a LEGO hub. Choose another one."));
    const characteristic = await step(service.getCharacteristic(CHARACTERISTIC),
      say("The chosen device is not a LEGO hub. Choose another one."));
    const out = createOutbox(characteristic, device);
    device.addEventListener("gattserverdisconnected", () => {
      out.close(true);
      listener.lost();
    }, { signal: closing.signal });
    characteristic.addEventListener("characteristicvaluechanged", () => {
      const { value } = characteristic;
      if (value) read(value, listener, out);
    }, { signal: closing.signal });
    await step(characteristic.startNotifications(), say("The hub refused notifications. Switch it off and on, then connect again."));
    out.put(`property ${BATTERY}`, [PROPERTY, BATTERY, REPORT]);
    out.put(`property ${BUTTON}`, [PROPERTY, BUTTON, REPORT]);
    out.put(`mode ${LIGHT}`, inputFormat(LIGHT, 0, false));
    return {
      name: device.name || "Move Hub",
      ...createMotors(out),
      /** @param {number} color from 0 (off) to 10 */
      light(color) {
        out.put(`port ${LIGHT}`, output(LIGHT, color));
      },
      /** End the connection after the last messages, which may stop the motors. */
      async disconnect() {
        out.close();
        await Promise.race([out.empty(), new Promise((resolve) => setTimeout(resolve, FAREWELL))]);
        disconnect();
      },
    };
  } catch (error) {
    disconnect();
    throw error;
  }
}

/**
 * The motors A and B. Only the latest power is sent, and only if it has changed.
 * @param {ReturnType<typeof createOutbox>} out
 */
function createMotors(out) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  let last = -PACE;
  let wanted = [0, 0];
  let sent = [0, 0];
  const write = (urgent = false) => {
    clearTimeout(timer);
    timer = undefined;
    last = performance.now();
    MOTORS.forEach((port, index) => {
      const power = wanted[index] ?? 0;
      if (urgent || power !== sent[index]) out.put(`port ${port}`, output(port, power), urgent);
    });
    sent = wanted;
  };
  return {
    /** @param {number} a @param {number} b in percent */
    drive(a, b) {
      wanted = [a, b];
      timer ??= setTimeout(write, Math.max(0, last + PACE - performance.now()));
    },
    /** Stop immediately, before messages that wait. */
    halt() {
      wanted = [0, 0];
      write(true);
    },
  };
}

/**
 * Write messages one after another, as Web Bluetooth requires. Of those for one `place`, only the latest waits.
 * @param {BluetoothCharacteristic} characteristic @param {BluetoothDevice} device
 */
function createOutbox(characteristic, device) {
  /** @type {Map<string, Uint8Array<ArrayBuffer>>} */
  let waiting = new Map();
  let writing = false;
  let closed = false;
  let last = Promise.resolve();
  /** @type {Promise<unknown> | undefined} */
  let passing;
  const send = async () => {
    writing = true;
    let failed = 0;
    for (let next; (next = waiting.entries().next().value);) {
      const [place, message] = next;
      waiting.delete(place);
      if (passing) await passing;
      passing = undefined;
      try {
        await characteristic.writeValueWithoutResponse(message);
        failed = 0;
      } catch {
        // Try again, unless there is a newer message: a motor that missed its stop would run on.
        if (!waiting.has(place)) waiting.set(place, message);
        if (++failed >= TRIES) waiting.clear();
      }
    }
    writing = false;
    // The hub does not respond: report the connection as lost.
    if (failed >= TRIES && device.gatt.connected) device.gatt.disconnect();
  };
  return {
    /** @param {string} place @param {number[]} body @param {boolean} [urgent] */
    put(place, body, urgent = false) {
      if (closed) return;
      const message = Uint8Array.of(body.length + 2, 0, ...body);
      waiting.delete(place);
      if (urgent) {
        waiting = new Map([[place, message], ...waiting]);
        // A page that is closing has no time to wait for the message in transit.
        if (writing) passing = Promise.allSettled([passing, characteristic.writeValueWithoutResponse(message)]);
      } else {
        waiting.set(place, message);
      }
      if (!writing) last = send();
    },
    empty: () => last,
    /** Accept no more messages; with `gone`, drop those that wait. */
    close(gone = false) {
      closed = true;
      if (gone) waiting.clear();
    },
  };
}

/** @param {DataView} message @param {Listener} listener @param {ReturnType<typeof createOutbox>} out */
function read(message, listener, out) {
  const at = (/** @type {number} */ index) => (index < message.byteLength ? message.getUint8(index) : 0);
  const signed = (/** @type {number} */ index) => (at(index) << 24) >> 24;
  const [kind, port] = [at(2), at(3)];
  if (kind === PROPERTY && port === BATTERY) listener.battery(at(5));
  if (kind === PROPERTY && port === BUTTON) listener.button(at(5) !== 0);
  if (kind === ATTACHED && at(4) === 1) {
    const type = at(5) | (at(6) << 8);
    for (const sensor of [COLOR_DISTANCE, TILT]) {
      if (type === sensor.type) out.put(`mode ${port}`, inputFormat(port, sensor.mode, true));
    }
  }
  // The tilt sensor is built in; the other sensor is plugged into one of the other ports.
  if (kind === VALUE && port === 0x3a) {
    listener.tilt((signed(4) * Math.PI) / 180, (signed(5) * Math.PI) / 180);
  } else if (kind === VALUE) {
    listener.distance(distance(at(5), at(7)));
  }
}

/**
 * Convert a reading to metres. The sensor reports inches and the denominator of a fraction, up to ten inches, from a
 * lens 2 cm behind its front.
 * @param {number} inches @param {number} part
 */
function distance(inches, part) {
  if (inches >= 10) return Infinity;
  return Math.max(0, (inches + (part > 0 ? 1 / part : 0)) * 0.0254 - 0.02);
}

/** @param {number} port @param {number} value */
function output(port, value) {
  return [OUTPUT, port, AT_ONCE, DIRECT, 0x00, value & 0xff];
}

/**
 * Set the mode of a port, with or without reports of changes.
 * @param {number} port @param {number} mode @param {boolean} report
 */
function inputFormat(port, mode, report) {
  return [INPUT_FORMAT, port, mode, 1, 0, 0, 0, report ? 1 : 0];
}

/**
 * Wait for a step; if it fails, throw an Error with `text`.
 * @template T @param {Promise<T> | undefined} promise @param {string} text @returns {Promise<T>}
 */
async function step(promise, text) {
  try {
    if (promise) return await promise;
  } catch (error) {
    if (error instanceof DOMException && error.name === "SecurityError") {
      text = say("The browser does not allow Bluetooth here. Open this page in its own tab, not embedded in another page.");
    }
    throw new Error(text, { cause: error });
  }
  throw new Error(obstacle());
}
