// @ts-check
// Interactive markers: what a node lets the visitor move, turn and press.

import { say } from "../../../ui/words.js";
import { Handle } from "../interactive/handle.js";
import { KeyList } from "../interactive/keyList.js";
import { Pointer } from "../interactive/pointer.js";
import { MarkerClient } from "../interactive/markerClient.js";

/** @import { Context, Kind } from "../shown.js" */

const FEEDBACK = "visualization_msgs/msg/InteractiveMarkerFeedback";
const MOST = 2000;

/** @type {Kind} */
export const kind = {
  title: say("Interactive markers"),
  types: ["visualization_msgs/msg/InteractiveMarkerUpdate"],
  defaults: { topic: "/interactive_markers/update", descriptions: true },

  create(context, options) {
    const markers = new InteractiveMarkers(context, options);
    return {
      controls: markers.keys.element,
      begin: () => markers.begin(),
      end: () => markers.end(),
      receive: (message) => markers.client.take(message),
      update: () => markers.update(),
      set: () => markers.set(),
      clear: () => markers.clear(),
      close: () => markers.close(),
    };
  },
};

class InteractiveMarkers {
  #context;
  #options;
  /** By name. @type {Map<string, Handle>} */
  #handles = new Map();
  #pointer;
  /** Why a marker is not shown, by its name. @type {Map<string, string>} */
  #faults = new Map();
  /** @type {import("../../../protocol.js").Publisher | undefined} */
  #feedback;
  #id = `page-${crypto.getRandomValues(new Uint32Array(1)).join("")}`;
  client;
  keys;
  /** Whether there are others than those in `keys`. */
  #changed = false;
  /** Whether the camera has shown them. */
  #appeared = false;

  /** @param {Context} context @param {Record<string, any>} options */
  constructor(context, options) {
    this.#context = context;
    this.#options = options;
    this.client = new MarkerClient(context.ros, () => this.#namespace, {
      reset: (markers) => {
        this.clear();
        this.#insert(markers);
      },
      update: ({ markers, poses, erases }) => {
        for (const name of erases) this.#remove(name);
        this.#insert(markers);
        for (const { name, header, pose } of poses) this.#handles.get(name)?.move(header, pose);
      },
      lost: () => this.clear(),
      say: (text) => this.#faults.set("", text),
    });
    const send = (/** @type {Handle} */ handle, /** @type {Record<string, any>} */ feedback) => this.#send(handle, feedback);
    this.#pointer = new Pointer(context.world.stage, () => this.#shown(), send);
    this.keys = new KeyList(context.world.stage.element, send);
  }

  get #namespace() {
    return String(this.#options.topic).replace(/\/update$/, "");
  }

  begin() {
    if (this.#context.ros.types[FEEDBACK]) {
      this.#feedback = this.#context.ros.advertise(`${this.#namespace}/feedback`, FEEDBACK);
    }
    this.client.begin();
  }

  end() {
    this.#pointer.release();
    this.client.end();
    this.#feedback?.close();
    this.#feedback = undefined;
  }

  set() {
    for (const handle of this.#handles.values()) handle.describe(this.#options.descriptions);
  }

  /** Place the markers, and turn what faces the visitor. */
  update() {
    const { place, world } = this.#context;
    if (this.#changed) this.keys.show([...this.#handles.values()]);
    this.#changed = false;
    let known = true;
    for (const handle of this.#handles.values()) {
      handle.place.visible = place(handle.place, handle.frame, handle.time);
      known &&= handle.place.visible;
      handle.face(world.stage.camera);
    }
    if (known && this.client.known) this.#context.say([...this.#faults.values()].slice(0, 3).join("; "));
  }

  clear() {
    this.#pointer.release();
    for (const name of [...this.#handles.keys()]) this.#remove(name);
    this.#faults.clear();
  }

  close() {
    this.end();
    this.#pointer.close();
    this.keys.close();
    this.client.close();
    this.clear();
  }

  #shown() {
    return this.#context.root.visible ? [...this.#handles.values()].filter(({ place }) => place.visible) : [];
  }

  /** @param {any[]} markers */
  #insert(markers) {
    for (const marker of markers) {
      this.#remove(marker.name);
      if (this.#handles.size >= MOST) {
        this.#faults.set("", say("more than {} markers", MOST));
        break;
      }
      try {
        const handle = new Handle(marker, this.#context);
        handle.describe(this.#options.descriptions);
        this.#handles.set(marker.name, handle);
        this.#changed = true;
        this.#context.root.add(handle.place);
        this.#context.world.heard(handle.frame);
      } catch (error) {
        this.#faults.set(marker.name, error instanceof Error ? error.message : String(error));
      }
    }
    this.#context.redraw();
    if (this.#handles.size && !this.#appeared) {
      this.#appeared = true;
      this.#context.world.appeared();
    }
  }

  /** @param {string} name */
  #remove(name) {
    this.#faults.delete(name);
    const handle = this.#handles.get(name);
    if (!handle) return;
    this.#pointer.release(handle);
    handle.close();
    this.#handles.delete(name);
    this.#changed = true;
    this.#context.redraw();
  }

  /** @param {Handle} handle @param {Record<string, any>} feedback */
  #send(handle, feedback) {
    this.#context.redraw();
    if (!this.#feedback) {
      this.#context.say(say("no node on this page uses {}", FEEDBACK));
      return;
    }
    try {
      this.#feedback.publish({ client_id: this.#id, marker_name: handle.name, header: handle.header, pose: handle.pose, ...feedback });
    } catch (error) {
      this.#context.say(error instanceof Error ? error.message : String(error));
    }
  }
}
