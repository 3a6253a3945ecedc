// @ts-check
// A node of the page itself in the graph: topics and services as JavaScript functions and objects.

import { BUDGETS } from "../budgets.js";
import { PAGE_NODE } from "../graphNames.js";
import { Codec } from "../messages/codec.js";
import { Participant } from "../participant/participant.js";
import { DEFAULT_QOS } from "../protocol.js";
import { say } from "../ui/words.js";
import { join } from "./companion.js";

// Only pages with panels need it, too.
export { addFullScreen } from "../ui/fullScreen.js";

/** @import { Graph } from "./graph.js" */
/** @import { Companion, MessageInfo, MessageType, Publisher, Qos } from "../protocol.js" */

// Panels that are too slow for a topic may miss messages.
const BEST_EFFORT = { ...DEFAULT_QOS, reliable: false };

export class PageClient {
  #graph;
  #codec;
  #participant;
  #handlers = new Map();
  #pumping = false;
  #node;
  #id;

  /**
   * @param {Graph} graph @param {Record<string, MessageType>} types
   * @param {string} [node] its name; without one, it is the page's hidden node
   */
  constructor(graph, types, node = "") {
    this.#graph = graph;
    this.types = types;
    this.#node = node || PAGE_NODE;
    this.#codec = new Codec(types);
    /** @type {Participant} */
    let participant;
    const warn = (/** @type {string} */ text) => console.warn(`the page ${text}`);
    const id = graph.join((message) => participant.receive(message), "", warn);
    participant = new Participant(id, (message) => graph.receive(id, message), false, BUDGETS.frame);
    this.#participant = participant;
    this.#id = id;
    if (node) participant.create("node", node, "", "", DEFAULT_QOS);
  }

  /**
   * Call `callback` with each message of a topic, as an object. Return a function that ends the subscription.
   * @param {string} topic @param {string} type
   * @param {(message: any, info: MessageInfo) => void} callback @param {Partial<Qos>} [qos]
   */
  subscribe(topic, type, callback, qos) {
    const read = (/** @type {Uint8Array} */ bytes, /** @type {MessageInfo} */ info) => {
      callback(this.#codec.read(type, bytes), info);
    };
    return this.subscribeBytes(topic, type, read, qos);
  }

  /**
   * Do the same with the bytes of the messages, which needs no definition of their type.
   * @param {string} topic @param {string} type
   * @param {(message: Uint8Array, info: MessageInfo) => void} callback @param {Partial<Qos>} [qos]
   */
  subscribeBytes(topic, type, callback, qos) {
    return this.#receive("subscription", topic, type, { ...BEST_EFFORT, ...qos }, (sample) => {
      const { message, sequence, timestamp, received, writer } = sample;
      callback(message, { size: message.length, sequence, timestamp, received, writer });
    }).close;
  }

  /** @param {string} topic @param {string} type @param {Partial<Qos>} [qos] @returns {Publisher} */
  advertise(topic, type, qos) {
    const id = this.#participant.create("publisher", this.#node, topic, type, { ...DEFAULT_QOS, ...qos });
    return {
      publish: (message) => {
        // Bytes are a message in CDR.
        const bytes = message instanceof Uint8Array ? message : this.#codec.write(type, message);
        const sent = this.#participant.publish(id, bytes);
        this.#participant.flush();
        if (!sent) throw new Error(say("the queues of the subscriptions to {} are full", topic));
      },
      close: () => this.#participant.destroy(id),
    };
  }

  /**
   * Call a service and resolve with the response. Reject if there is no server, no response within `timeout` ms, which
   * may be infinite, or with the reason of `signal` when that aborts.
   * @param {string} service @param {string} type @param {any} request @param {number} [timeout]
   * @param {AbortSignal} [signal]
   * @returns {Promise<any>}
   */
  call(service, type, request, timeout = 5000, signal) {
    return new Promise((resolve, reject) => {
      const bytes = this.#codec.write(`${type}_Request`, request);
      const client = this.#receive("client", service, type, DEFAULT_QOS, (sample) => {
        done(() => resolve(this.#codec.read(`${type}_Response`, sample.message)));
      });
      // The timers of browsers take an infinite time for none.
      const timer = timeout === Infinity ? undefined : setTimeout(() => {
        done(() => reject(new Error(say("no response from {} within {} s", service, timeout / 1000))));
      }, timeout);
      const aborted = () => done(() => reject(signal?.reason));
      signal?.addEventListener("abort", aborted);
      const done = (/** @type {() => void} */ settle) => {
        clearTimeout(timer);
        signal?.removeEventListener("abort", aborted);
        client.close();
        try {
          settle();
        } catch (error) {
          reject(error);
        }
      };
      if (signal?.aborted) {
        aborted();
        return;
      }
      if (this.#participant.matched(client.id) === 0) {
        done(() => reject(new Error(say("no server for {} now", service))));
        return;
      }
      this.#participant.request(client.id, bytes);
      this.#participant.flush();
    });
  }

  /**
   * Offer a service: `answer` returns the response to a request, or a promise of it. ROS has no answer that is an
   * error: if `answer` throws, the request gets none. Return a function that ends the service.
   * @param {string} service @param {string} type @param {(request: any) => any} answer @returns {() => void}
   */
  serve(service, type, answer) {
    const server = this.#receive("service", service, type, DEFAULT_QOS, async ({ writer, sequence, message }) => {
      try {
        const response = await answer(this.#codec.read(`${type}_Request`, message));
        this.#participant.respond(server.id, writer, sequence, this.#codec.write(`${type}_Response`, response ?? {}));
        this.#participant.flush();
      } catch (error) {
        console.error(error);
      }
    });
    return server.close;
  }

  /** Return the object of a message in CDR. @param {string} type @param {Uint8Array} bytes @returns {any} */
  read(type, bytes) {
    return this.#codec.read(type, bytes);
  }

  /** Return another node of the page in the graph. @param {string} name */
  node(name) {
    return new PageClient(this.#graph, this.types, name);
  }

  /** Leave the graph. */
  leave() {
    this.#handlers.clear();
    this.#graph.leave(this.#id);
    this.#participant.wake();
  }

  /**
   * Start a worker of the runtime that takes part in the graph, such as the player of a bag.
   * @param {string} file of the worker, below workers/ @param {(message: any) => void} told called with what it tells
   * @param {(error: string) => void} failed called when it has ended by an error @returns {Companion}
   */
  join(file, told, failed) {
    return join(this.#graph, file, told, failed);
  }

  /**
   * @param {"subscription" | "client" | "service"} kind @param {string} name @param {string} type @param {Qos} qos
   * @param {(sample: import("../participant/queue.js").Received) => void} handler
   */
  #receive(kind, name, type, qos, handler) {
    const id = this.#participant.create(kind, this.#node, name, type, qos);
    this.#handlers.set(id, handler);
    this.#pump();
    return {
      id,
      close: () => {
        this.#handlers.delete(id);
        this.#participant.destroy(id);
      },
    };
  }

  /** Call the handlers of messages that arrive, as long as there are any. */
  async #pump() {
    if (this.#pumping) return;
    this.#pumping = true;
    while (this.#handlers.size > 0) {
      for (const [id, handler] of this.#handlers) {
        for (let sample; (sample = this.#participant.take(id));) {
          try {
            handler(sample);
          } catch (error) {
            console.error(error);
          }
        }
      }
      await this.#participant.wait(-1);
    }
    this.#pumping = false;
  }
}
