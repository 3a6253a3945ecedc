// @ts-check
// Parameters, as rosapi has them: "/node:parameter", or a name alone, as programs for ROS 1 write it; values are in JSON.

import { fullName } from "../../client/names.js";
import { Parameters } from "../../client/parameters.js";
import { nodesOf } from "../../messages/parameters/node.js";
import { LONGEST_NAME } from "../limits.js";
import { Mistake, textOf } from "../mistake.js";
import { Asking } from "./asking.js";
import { Kept } from "./kept.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Session } from "../session.js" */
/** @typedef {{get(name: string): any, set(name: string, value: any): any}} Holder a node, or what the client keeps */

const OK = { successful: true, reason: "" };

export class ParameterServices {
  #session;
  /** Parameters that no node has. */
  #kept = new Kept();
  #asking;

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
    this.#asking = new Asking(session);
  }

  /** What the services do, by name. @type {Record<string, (request: any) => Promise<any>>} */
  #done = {
    get_param: async ({ name, default_value, default: given }) => {
      const otherwise = given || default_value;
      try {
        const value = await this.#get(name);
        if (value !== undefined) return { value: jsonOf(value), ...OK };
      } catch (error) {
        return { value: otherwise, successful: false, reason: textOf(error) };
      }
      if (otherwise) return { value: otherwise, ...OK };
      return { value: "", successful: false, reason: `parameter ${name.slice(0, 200)} is not set` };
    },
    set_param: async ({ name, value }) => this.#changed(async () => {
      const [holder, own] = await this.#find(name);
      await holder.set(own, parsed(value));
    }),
    has_param: async ({ name }) => {
      try {
        return { exists: (await this.#get(name)) !== undefined };
      } catch {
        return { exists: false };
      }
    },
    delete_param: async ({ name }) => this.#changed(async () => {
      const [holder, own] = await this.#find(name);
      await holder.set(own, undefined);
    }),
    get_param_names: async () => {
      const names = await this.#asking.all(this.#nodes(), async (parameters) =>
        (await parameters.names()).map((name) => `${parameters.node}:${name}`));
      return { names: [...names, ...this.#kept.names().map((name) => `/${name}`)] };
    },
  };

  /** The services, by name. @type {Record<string, (request: any) => any>} */
  services = Object.fromEntries(Object.entries(this.#done).map(([name, answer]) =>
    [name, (/** @type {any} */ request) => this.#asking.inTurn(nodeOf(request.name), () => answer(request))]));

  /** @param {string} name */
  async #get(name) {
    const [holder, own] = await this.#find(name);
    return holder.get(own);
  }

  /** @param {string} name @returns {Promise<[Holder, string]>} who has the parameter, and its name there */
  async #find(name) {
    const full = nodeOf(name);
    if (!full) return this.#findAlone(name);
    const own = name.slice(name.indexOf(":") + 1);
    const { raw, surroundings } = this.#session;
    if (!surroundings.serversOf(`${full}/get_parameters`).length) {
      throw new Mistake(`there is no node ${full} with parameters`);
    }
    return [new Parameters(raw, surroundings, full), own];
  }

  /** @param {string} name without a node @returns {Promise<[Holder, string]>} */
  async #findAlone(name) {
    const own = name.replace(/^\//, "");
    if (!/^[^\s:]+$/.test(own) || own.length > LONGEST_NAME) {
      throw new Mistake(`'${name.slice(0, 200)}' is not the name of a parameter; write '/node:parameter'`);
    }
    const [found, ...others] = await this.#asking.all(this.#nodes(), async (parameters) =>
      ((await parameters.get(own)) === undefined ? [] : [parameters]));
    if (found && others.length) {
      const nodes = [found, ...others].map(({ node }) => node).join(", ");
      throw new Mistake(`${nodes} have a parameter '${own}'; write '${found.node}:${own}'`);
    }
    return [found ?? this.#kept, own];
  }

  /** The nodes that have parameters. */
  #nodes() {
    const { graph } = this.#session;
    return nodesOf(/** @type {Ros} */ (/** @type {unknown} */ ({ graph })));
  }

  /** @param {() => Promise<void>} change */
  async #changed(change) {
    try {
      await change();
      return OK;
    } catch (error) {
      return { successful: false, reason: textOf(error) };
    }
  }
}

/** The full name of the node in "/node:parameter", "" in the name of a parameter alone. @param {string} name */
function nodeOf(name) {
  const [, node = ""] = /^([^:]+):.+$/.exec(name) ?? [];
  return node && fullName(node);
}

/** @param {string} text */
function parsed(text) {
  try {
    return JSON.parse(text);
  } catch {
    throw new Mistake("the value of a parameter is a text in JSON");
  }
}

/** @param {any} value */
function jsonOf(value) {
  const plain = value instanceof Uint8Array ? Array.from(value) : value;
  return JSON.stringify(plain, (_, one) => (typeof one === "bigint" ? Number(one) : one));
}
