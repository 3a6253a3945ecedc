// @ts-check
// Parameters, as rosapi has them: "/node:parameter", with values in JSON.

import { fullName } from "../../client/names.js";
import { Parameters } from "../../client/parameters.js";
import { nodesOf } from "../../messages/parameters/node.js";
import { Mistake, textOf } from "../mistake.js";

/** @import { Ros } from "../../protocol.js" */
/** @import { Session } from "../session.js" */

const OK = { successful: true, reason: "" };

export class ParameterServices {
  #session;

  /** @param {Session} session */
  constructor(session) {
    this.#session = session;
  }

  /** The services, by name. @type {Record<string, (request: any) => any>} */
  services = {
    get_param: async ({ name, default_value: other = "", default: old = other }) => {
      try {
        const value = await this.#get(name);
        if (value !== undefined) return { value: jsonOf(value), ...OK };
      } catch (error) {
        return { value: String(old), successful: false, reason: textOf(error) };
      }
      if (old !== "") return { value: String(old), ...OK };
      return { value: "", successful: false, reason: `parameter ${String(name).slice(0, 200)} is not set` };
    },
    set_param: async ({ name, value }) => this.#changed(async () => {
      const [parameters, own] = this.#find(name);
      await parameters.set(own, parsed(value));
    }),
    has_param: async ({ name }) => {
      try {
        return { exists: (await this.#get(name)) !== undefined };
      } catch {
        return { exists: false };
      }
    },
    delete_param: async ({ name }) => this.#changed(async () => {
      const [parameters, own] = this.#find(name);
      await parameters.set(own, undefined);
    }),
    get_param_names: async () => {
      const { raw, graph, surroundings } = this.#session;
      const nodes = nodesOf(/** @type {Ros} */ (/** @type {unknown} */ ({ graph })));
      const all = nodes.map(async (node) => {
        try {
          return (await new Parameters(raw, surroundings, node).names()).map((name) => `${node}:${name}`);
        } catch {
          return []; // the node ended meanwhile
        }
      });
      return { names: (await Promise.all(all)).flat() };
    },
  };

  /** @param {string} name */
  async #get(name) {
    const [parameters, own] = this.#find(name);
    return parameters.get(own);
  }

  /** @param {unknown} name @returns {[Parameters, string]} the node, and the parameter's name there */
  #find(name) {
    const [, node, own] = /^([^:]+):(.+)$/.exec(String(name)) ?? [];
    if (!node || !own) {
      throw new Mistake(`'${String(name).slice(0, 200)}' is not the name of a parameter; write '/node:parameter'`);
    }
    const { raw, surroundings } = this.#session;
    const full = fullName(node);
    if (!surroundings.serversOf(`${full}/get_parameters`).length) {
      throw new Mistake(`there is no node ${full} with parameters`);
    }
    return [new Parameters(raw, surroundings, full), own];
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

/** @param {unknown} text */
function parsed(text) {
  if (typeof text !== "string") throw new Mistake("the value of a parameter is a text in JSON");
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
