// @ts-check
// Topics and services of one node as JavaScript functions and objects.

import { Codec } from "../messages/codec.js";
import { DEFAULT_QOS } from "../protocol.js";
import { say } from "../ui/words.js";

/** @import { Endpoint, MessageInfo, MessageType, Publisher, Qos } from "../protocol.js" */
/** @import { Participant } from "./participant.js" */
/** @import { Received } from "./queue.js" */

// Those who are too slow for a topic may miss messages.
const BEST_EFFORT = { ...DEFAULT_QOS, reliable: false };

export class NodeClient {
  #codec;
  #participant;
  #node;
  /** By id of their endpoint. @type {Map<number, (sample: Received) => void>} */
  #handlers = new Map();
  #pumping = false;

  /**
   * @param {Participant} participant @param {string} node its name
   * @param {Record<string, MessageType>} types
   */
  constructor(participant, node, types) {
    this.#participant = participant;
    this.#node = node;
    this.#codec = new Codec(types);
    this.types = types;
  }

  /**
   * Call `callback` with each message of a topic, as an object. Return a function that ends the subscription.
   * @param {string} topic @param {string} type
   * @param {(message: any, info: MessageInfo) => void} callback @param {Partial<Qos>} [qos]
   */
  subscribe(topic, type, callback, qos) {
    return this.subscribeBytes(topic, type, (bytes, info) => callback(this.#codec.read(type, bytes), info), qos);
  }

  /**
   * Do the same with the bytes of the messages, which needs no definition of their type.
   * @param {string} topic @param {string} type
   * @param {(message: Uint8Array, info: MessageInfo) => void} callback @param {Partial<Qos>} [qos]
   */
  subscribeBytes(topic, type, callback, qos) {
    const given = { ...BEST_EFFORT, ...qos };
    return this.#receive("subscription", topic, type, given, ({ message, ...info }) => {
      callback(message, { ...info, size: message.length });
    }).close;
  }

  /** @param {string} topic @param {string} type @param {Partial<Qos>} [qos] @returns {Publisher} */
  advertise(topic, type, qos) {
    const graph = this.#participant;
    const id = this.create("publisher", topic, type, { ...DEFAULT_QOS, ...qos });
    return {
      // In a worker, others may not know of the publisher yet.
      publish: (message) => {
        // Bytes are a message in CDR.
        const bytes = message instanceof Uint8Array ? message : this.#codec.write(type, message);
        let sent = true;
        graph.whenAnnounced(() => {
          sent = graph.publish(id, bytes);
          graph.flush();
        });
        if (!sent) throw new Error(say("the queues of the subscriptions to {} are full", topic));
      },
      close: () => graph.whenAnnounced(() => this.destroy(id)),
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
      const graph = this.#participant;
      const bytes = this.#codec.write(`${type}_Request`, request);
      const client = this.#receive("client", service, type, DEFAULT_QOS, ({ message }) => {
        done(() => resolve(this.#codec.read(`${type}_Response`, message)));
      });
      // The timers of browsers take an infinite time for none.
      const timer = timeout === Infinity ? undefined : setTimeout(() => {
        fail(new Error(say("no response from {} within {} s", service, timeout / 1000)));
      }, timeout);
      const aborted = () => fail(signal?.reason);
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
      const fail = (/** @type {unknown} */ error) => done(() => reject(error));
      // In a worker, the servers are known later.
      graph.whenAnnounced(() => {
        try {
          signal?.throwIfAborted();
          if (!graph.matched(client.id)) throw new Error(say("no server for {} now", service));
          graph.request(client.id, bytes);
          graph.flush();
        } catch (error) {
          fail(error);
        }
      });
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

  /**
   * Create an endpoint of the node and return its id.
   * @param {Endpoint["kind"]} kind @param {string} name @param {string} type @param {Qos} qos
   */
  create(kind, name, type, qos) {
    return this.#participant.create(kind, this.#node, name, type, qos);
  }

  /** @param {number} id of an endpoint */
  destroy(id) {
    this.#participant.destroy(id);
  }

  /** Return the object of a message in CDR. @param {string} type @param {Uint8Array} bytes @returns {any} */
  read(type, bytes) {
    return this.#codec.read(type, bytes);
  }

  /** Call no handler any more. */
  leave() {
    this.#handlers.clear();
    this.#participant.wake();
  }

  /**
   * @param {"subscription" | "client" | "service"} kind @param {string} name @param {string} type @param {Qos} qos
   * @param {(sample: Received) => void} handler
   */
  #receive(kind, name, type, qos, handler) {
    const id = this.create(kind, name, type, qos);
    this.#handlers.set(id, handler);
    this.#pump();
    return {
      id,
      close: () => {
        this.#handlers.delete(id);
        this.destroy(id);
      },
    };
  }

  /** Call the handlers of messages that arrive, as long as there are any. */
  async #pump() {
    if (this.#pumping) return;
    this.#pumping = true;
    while (this.#handlers.size) {
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
