// @ts-check
// Operations about services: call_service, advertise_service, unadvertise_service, service_response.

import { fullName, fullType } from "../client/names.js";
import { checkFields, Mistake, textOf } from "./mistake.js";
import { MOST_NAMES } from "./limits.js";

/** @import { Session } from "./session.js" */
/** @typedef {{service: string, settle(values: any): void, fail(error: Error): void}} Pending */

/** How long a call waits without a `timeout` of its own, as rosbridge_suite has it (ms). */
const PATIENCE = 5000;

export class Services {
  #session;
  /** @type {Map<string, {type: string, end: () => void}>} */
  #served = new Map();
  /** Requests that the client has not answered, by id. @type {Map<unknown, Pending>} */
  #pending = new Map();
  #next = 1;
  #calls = 0;

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
  }

  /** @type {Record<string, (message: any) => void>} */
  operations = {
    call_service: (message) => { this.#call(message); },
    advertise_service: (message) => this.#advertise(message),
    unadvertise_service: (message) => this.#unadvertise(message),
    service_response: (message) => this.#respond(message),
  };

  /** @param {any} message */
  async #call(message) {
    const { id } = message;
    const answer = (/** @type {boolean} */ result, /** @type {any} */ values) => this.#session.send({
      op: "service_response", ...(id !== undefined && { id }), service: message.service, values, result,
    }, message.compression === "png" ? "png" : "none", message.fragment_size);
    if (this.#calls >= MOST_NAMES) {
      answer(false, "too many calls at a time");
      return;
    }
    this.#calls++;
    try {
      checkFields(message, { service: "string", "args?": "object", "timeout?": "number", "fragment_size?": "number" });
      answer(true, await this.#ask(message));
    } catch (error) {
      this.#session.status("error", `call_service: ${textOf(error)}`, id);
      answer(false, textOf(error));
    } finally {
      this.#calls--;
    }
  }

  /** @param {any} message @returns {Promise<any>} the response, in JSON */
  async #ask({ service, args, timeout }) {
    const name = fullName(service.split("#")[0]);
    const { raw, rosapi, surroundings, values } = this.#session;
    const own = rosapi.serviceOf(name);
    if (own) return own(args ?? {});
    const type = surroundings.typeOf("services", name);
    if (!surroundings.serversOf(name).length) throw new Mistake(`there is no service ${name}`);
    const request = values.read(`${type}_Request`, args);
    const wait = timeout === undefined ? PATIENCE : timeout > 0 ? timeout * 1000 : Infinity;
    const response = await raw.call(name, type, request, wait, this.#session.signal);
    return values.toJson(`${type}_Response`, response);
  }

  /** @param {any} message */
  #advertise(message) {
    checkFields(message, { service: "string", type: "string" });
    const name = fullName(message.service);
    const type = fullType(message.type, "srv");
    const { raw, values } = this.#session;
    if (!values.knows(`${type}_Request`)) throw new Mistake(`this page has no definition of ${type}`);
    this.#served.get(name)?.end();
    if (this.#served.size >= MOST_NAMES) throw new Mistake("advertise_service: too many services");
    const end = raw.serve(name, type, async (request) => {
      try {
        const given = await this.#forward(name, values.toJson(`${type}_Request`, request));
        return values.read(`${type}_Response`, given);
      } catch (error) {
        this.#session.status("error", `service_response: ${textOf(error)}`);
        // ROS has no response that says so; the caller waits as long as it wants.
        return new Promise(() => {});
      }
    });
    this.#served.set(name, { type, end });
  }

  /** @param {any} message */
  #unadvertise(message) {
    checkFields(message, { service: "string" });
    const name = fullName(message.service);
    const served = this.#served.get(name);
    if (!served) throw new Mistake(`unadvertise_service: this client does not advertise ${name}`);
    served.end();
    this.#served.delete(name);
    for (const [id, { service, fail }] of this.#pending) {
      if (service !== name) continue;
      this.#pending.delete(id);
      fail(new Mistake(`${name} was unadvertised`));
    }
  }

  /**
   * Send a request to the client and resolve with its response.
   * @param {string} service @param {any} args @returns {Promise<any>}
   */
  #forward(service, args) {
    if (this.#pending.size >= MOST_NAMES) throw new Mistake(`${service}: the client does not answer`);
    const id = `service_request:${service}:${this.#next++}`;
    return new Promise((settle, fail) => {
      this.#pending.set(id, { service, settle, fail });
      this.#session.send({ op: "call_service", id, service, args });
    });
  }

  /** @param {any} message */
  #respond(message) {
    checkFields(message, { service: "string", "result?": "boolean" });
    const pending = this.#pending.get(message.id);
    if (!pending) throw new Mistake(`service_response: no request with this id waits at ${message.service}`);
    this.#pending.delete(message.id);
    const { result, values } = message;
    if (result === false) pending.fail(new Mistake(`${pending.service} failed: ${textOf(values ?? "no reason given")}`));
    else pending.settle(values ?? {});
  }
}
