// @ts-check
// The connection to a real Vernie, which the visitor starts and ends by a button.

import { place } from "../../../place.js";
import { button, setText } from "../../../ui/elements.js";
import { say } from "../../../ui/words.js";
import { obstacle } from "../parts/bluetooth.js";

/** @import { Listener, MoveHub } from "../parts/moveHub.js" */

/** @typedef {Omit<Listener, "lost">} Sensors what the hub reports to while it is connected */

export class Connection {
  #sensors;
  #changed;
  #closed = false;
  connecting = false;
  /** @type {MoveHub | undefined} */
  hub;
  /** Why connecting failed or the connection ended, or "". */
  trouble = "";
  button = button(say("Connect"), "ros-connect", () => (this.hub ? this.#end("") : this.#begin()));

  /**
   * @param {Sensors} sensors
   * @param {() => void} changed called when connecting begins, succeeds or fails, and when a connection ends
   */
  constructor(sensors, changed) {
    this.#sensors = sensors;
    this.#changed = changed;
    this.#show();
  }

  close() {
    this.#closed = true;
    this.#end("");
  }

  async #begin() {
    this.connecting = true;
    this.trouble = "";
    this.#update();
    try {
      const lost = say("The connection was lost: the hub is off or too far away. Connect again.");
      // Few visitors have such a robot.
      /** @type {typeof import("../parts/moveHub.js")} */
      const { connect } = await import(place("widgets/robots/parts/moveHub.js"));
      const hub = await connect({ ...this.#sensors, lost: () => this.#end(lost) });
      if (this.#closed) {
        hub.disconnect();
        return;
      }
      this.hub = hub;
    } catch (error) {
      this.trouble = error instanceof Error ? error.message : String(error);
    }
    this.connecting = false;
    this.#update();
  }

  /** @param {string} reason */
  #end(reason) {
    this.hub?.halt();
    this.hub?.disconnect();
    this.hub = undefined;
    this.trouble = reason;
    this.#update();
  }

  #update() {
    this.#show();
    this.#changed();
  }

  #show() {
    const offer = this.connecting ? say("Connecting…") : say("Connect");
    setText(this.button, this.hub ? say("Disconnect") : offer);
    this.button.disabled = this.connecting || obstacle() !== "";
  }
}
