// @ts-check
// A LEGO Move Hub over Web Bluetooth: what is needed of the LEGO Wireless Protocol 3.

import { say } from "../../../ui/words.js";

const SERVICE = "00001623-1212-efde-1623-785feabcde23";
const CHARACTERISTIC = "00001624-1212-efde-1623-785feabcde23";
// Messages begin with their length, a zero and one of these.
const PROPERTY = 0x01;
const ATTACHED = 0x04;
const INPUT_FORMAT = 0x41;
const VALUE = 0x45;
const OUTPUT = 0x81;
// Properties, and what is asked about them.
const BUTTON = 0x02;
const BATTERY = 0x06;
const REPORT = 0x02;
// Ports of the hub, and the sensors that say themselves where they are.
const MOTORS = [0x00, 0x01];
const LIGHT = 0x32;
const COLOR_DISTANCE = { type: 0x25, mode: 0x08 };
const TILT = { type: 0x28, mode: 0x00 };
// Begin at once, whatever the port does, and tell when it is done; write to the device directly.
const AT_ONCE = 0x11;
const DIRECT = 0x51;
// The motors are written this often (ms) at most: a radio takes its time, and what waits is late.
const PACE = 50;
const TRIES = 3;
// How long (ms) the last messages may take.
const FAREWELL = 500;

/**
 * What a hub tells: the charge of its battery (%), whether its button is pressed, what it sees, how it
 * is tilted (radians), and that the connection has ended.
 * @typedef {{
 *   battery(percent: number): void,
 *   button(pressed: boolean): void,
 *   distance(metres: number): void,
 *   tilt(x: number, y: number): void,
 *   lost(): void,
 * }} Listener
 * @typedef {Awaited<ReturnType<typeof connect>>} MoveHub
 */

/** Why this page cannot reach a hub, or "". */
export function obstacle() {
  if (!window.isSecureContext) {
    return say("Browsers allow Bluetooth only on https:// pages and on this computer. " +
      "Open this page at such an address to connect a robot.");
  }
  if (!navigator.bluetooth) {
    return say("This browser does not support Web Bluetooth. " +
      "Chrome and Edge do, on computers and on Android. The simulated robot works without it.");
  }
  return "";
}

/**
 * Let the visitor choose a hub, and connect to it. Must be called by a click. Rejects with an Error
 * that says what happened and what to do.
 * @param {Listener} listener
 */
export async function connect(listener) {
  const device = await step(
    navigator.bluetooth?.requestDevice({ filters: [{ services: [SERVICE] }] }),
    say("No hub was chosen. Press the green button on the hub so that its light blinks, then connect again."),
  );
  // Before anything can fail: what fails later must not leave a connection behind.
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
      /** @param {number} color its number, from 0 (off) to 10 */
      light(color) {
        out.put(`port ${LIGHT}`, output(LIGHT, color));
      },
      /** End the connection, after what waits: the motors may have to be stopped. */
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
 * The motors A and B. Only the newest power counts, and only what changes is sent.
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
    /** Stop now: not after what waits, nor after a pause. */
    halt() {
      wanted = [0, 0];
      write(true);
    },
  };
}

/**
 * Write messages one at a time, as Bluetooth wants it. Of those for one `place` only the newest waits.
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
        // A motor that missed its stop goes on, so it is told again, unless there is news for it.
        if (!waiting.has(place)) waiting.set(place, message);
        if (++failed >= TRIES) waiting.clear();
      }
    }
    writing = false;
    // A hub that takes nothing is as good as gone, and the visitor has to know.
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
        // A page that closes does not come back to what waits: try past the message on its way, too.
        if (writing) passing = Promise.allSettled([passing, characteristic.writeValueWithoutResponse(message)]);
      } else {
        waiting.set(place, message);
      }
      if (!writing) last = send();
    },
    empty: () => last,
    /** Take no more; with `gone` what waits is lost. */
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
  // The tilt sensor is a part of the hub, what is at another port is what was plugged in.
  if (kind === VALUE && port === 0x3a) {
    listener.tilt((signed(4) * Math.PI) / 180, (signed(5) * Math.PI) / 180);
  } else if (kind === VALUE) {
    listener.distance(distance(at(5), at(7)));
  }
}

/**
 * The sensor counts inches and a part of one, sees ten at most, and its glass is 2 cm behind its front.
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

/** Take a mode, and report each change or none. @param {number} port @param {number} mode @param {boolean} report */
function inputFormat(port, mode, report) {
  return [INPUT_FORMAT, port, mode, 1, 0, 0, 0, report ? 1 : 0];
}

/**
 * Say in our words why a step failed.
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
