// @ts-check
// Services of the robot for the page, and of the page for the robot.

import { now } from "../../protocol.js";
import { infrastructureOf, isHidden } from "../../graphNames.js";
import { Mistake, textOf } from "../mistake.js";

/** @import { RemoteEndpoint } from "../../gateway/wire.js" */
/** @import { Head } from "../../protocol.js" */
/** @import { Bridge } from "./bridge.js" */
/** @typedef {{service: RemoteEndpoint, resolve(values: any): void, reject(error: Error): void}} Asked */

// Calls of the robot that the page has not answered.
const MOST = 1000;

export class Services {
  #bridge;
  /** Those that are offered, by id. @type {Map<number, RemoteEndpoint>} */
  #offered = new Map();
  /** What services of the page were asked, by number. @type {Map<number, Asked>} */
  #asked = new Map();
  #numbers = 0;

  /** @param {Bridge} bridge */
  constructor(bridge) {
    this.#bridge = bridge;
  }

  /** Offer a service of the page. @param {RemoteEndpoint} endpoint */
  offer(endpoint) {
    const { id, name, type } = endpoint;
    // Those of a node's parameters are of no use without the node, and the robot's graph has none of the page.
    if (isHidden(name) || infrastructureOf(name)) return;
    this.#offered.set(id, endpoint);
    this.#bridge.emit({ op: "advertise_service", id: `own:${id}`, service: name, type });
  }

  /** A service of the page has gone. @param {RemoteEndpoint} endpoint */
  withdraw({ id, name }) {
    if (this.#offered.delete(id)) this.#bridge.emit({ op: "unadvertise_service", id: `own:${id}`, service: name });
    for (const [number, { service, reject }] of this.#asked) {
      if (service.id !== id) continue;
      this.#asked.delete(number);
      reject(new Mistake(`${name} has ended`));
    }
  }

  /** Whether the robot's server was offered a service of the page. @param {number} id */
  offers(id) {
    return this.#offered.has(id);
  }

  /** The robot calls a service of the page. @param {{id?: unknown, service?: unknown, args?: any}} message */
  async serve({ id, service: name, args }) {
    const service = [...this.#offered.values()].find((own) => own.name === name);
    if (!service) return;
    const answer = { op: "service_response", id, service: service.name };
    try {
      await this.#bridge.types.need(`${service.type}_Request`);
      this.#bridge.emit({ ...answer, values: await this.ask(service, args), result: true });
    } catch (error) {
      this.#bridge.note(service.name, textOf(error));
      this.#bridge.emit({ ...answer, values: {}, result: false });
    }
  }

  /**
   * Ask a service of the page, and return its response as rosbridge has it.
   * @param {RemoteEndpoint} service @param {any} args @returns {Promise<any>}
   */
  ask(service, args) {
    const type = `${service.type}_Request`;
    return new Promise((resolve, reject) => {
      const request = this.#bridge.codec.write(type, this.#bridge.values.read(type, args));
      if (this.#asked.size >= MOST) throw new Mistake("too many calls wait for an answer");
      this.#numbers += 1;
      this.#asked.set(this.#numbers, { service, resolve, reject });
      this.#bridge.deliver({ reader: service.id, writer: 0, sequence: this.#numbers, timestamp: now() }, request);
    });
  }

  /** A service of the page answers. @param {number} number of the call @param {Uint8Array} message */
  answer(number, message) {
    const asked = this.#asked.get(number);
    if (!asked) return;
    this.#asked.delete(number);
    const type = `${asked.service.type}_Response`;
    asked.resolve(this.#bridge.values.toExact(type, this.#bridge.codec.read(type, message)));
  }

  /**
   * The page calls a service of the robot.
   * @param {RemoteEndpoint} service @param {Head} head @param {Uint8Array} message
   */
  async call(service, head, message) {
    const { name, type } = service;
    const request = `${type}_Request`;
    try {
      const args = this.#bridge.values.toExact(request, this.#bridge.codec.read(request, message));
      await this.#bridge.types.need(`${type}_Response`);
      this.respond(service, head, await this.#bridge.calls.call(name, args));
    } catch (error) {
      this.#bridge.note(name, textOf(error));
    }
  }

  /**
   * Answer a call of the page.
   * @param {RemoteEndpoint} service of the robot @param {Head} head of the call @param {any} values
   */
  respond({ id, type }, { writer, sequence }, values) {
    const response = `${type}_Response`;
    const bytes = this.#bridge.codec.write(response, this.#bridge.values.read(response, values));
    this.#bridge.deliver({ reader: writer, writer: id, sequence, timestamp: now() }, bytes);
  }
}
