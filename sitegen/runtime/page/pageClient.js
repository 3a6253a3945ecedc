// @ts-check
// The page's own node in the graph: topics and services as JavaScript functions and objects.

import { PAGE_NODE } from "../graphNames.js";
import { Codec } from "../messages/codec.js";
import { Participant } from "../participant/participant.js";
import { DEFAULT_QOS } from "../protocol.js";
import { say } from "../ui/words.js";

/** @import { Graph } from "./graph.js" */
/** @import { MessageInfo, MessageType, Publisher, Qos } from "../protocol.js" */

// Panels that are too slow for a topic may miss messages.
const BEST_EFFORT = { ...DEFAULT_QOS, reliable: false };

export class PageClient {
  #codec;
  #participant;
  #handlers = new Map();
  #pumping = false;

  /** @param {Graph} graph @param {Record<string, MessageType>} types */
  constructor(graph, types) {
    this.#codec = new Codec(types);
    /** @type {Participant} */
    let participant;
    const warn = (/** @type {string} */ text) => console.warn(`the page ${text}`);
    const id = graph.join((message) => participant.receive(message), "", warn);
    participant = new Participant(id, (message) => graph.receive(id, message));
    this.#participant = participant;
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
      const { message, sequence, timestamp, received } = sample;
      callback(message, { size: message.length, sequence, timestamp, received });
    }).close;
  }

  /** @param {string} topic @param {string} type @param {Partial<Qos>} [qos] @returns {Publisher} */
  advertise(topic, type, qos) {
    const id = this.#participant.create("publisher", PAGE_NODE, topic, type, { ...DEFAULT_QOS, ...qos });
    return {
      publish: (message) => {
        const sent = this.#participant.publish(id, this.#codec.write(type, message));
        this.#participant.flush();
        if (!sent) throw new Error(say("the queues of the subscriptions to {} are full", topic));
      },
      close: () => this.#participant.destroy(id),
    };
  }

  /**
   * Call a service and resolve with the response. Reject if there is no server, or no response within `timeout` ms.
   * @param {string} service @param {string} type @param {any} request @param {number} [timeout]
   * @returns {Promise<any>}
   */
  call(service, type, request, timeout = 5000) {
    return new Promise((resolve, reject) => {
      const bytes = this.#codec.write(`${type}_Request`, request);
      const client = this.#receive("client", service, type, DEFAULT_QOS, (sample) => {
        done(() => resolve(this.#codec.read(`${type}_Response`, sample.message)));
      });
      const timer = setTimeout(() => {
        done(() => reject(new Error(say("no response from {} within {} s", service, timeout / 1000))));
      }, timeout);
      const done = (/** @type {() => void} */ settle) => {
        clearTimeout(timer);
        client.close();
        try {
          settle();
        } catch (error) {
          reject(error);
        }
      };
      if (this.#participant.matched(client.id) === 0) {
        done(() => reject(new Error(say("no server for {} now", service))));
        return;
      }
      this.#participant.request(client.id, bytes);
      this.#participant.flush();
    });
  }

  /**
   * @param {"subscription" | "client"} kind @param {string} name @param {string} type @param {Qos} qos
   * @param {(sample: import("../participant/queue.js").Received) => void} handler
   */
  #receive(kind, name, type, qos, handler) {
    const id = this.#participant.create(kind, PAGE_NODE, name, type, qos);
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
