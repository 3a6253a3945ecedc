// @ts-check
// What is wrong with a message of a client, as it is told.

/** An error of the client, whose text is sent as a status: in English, as clients are programs. */
export class Mistake extends Error {}

/** @param {unknown} error */
export function textOf(error) {
  return (error instanceof Error ? error.message : String(error)).slice(0, 1000);
}

/**
 * The fields of an operation, checked.
 * @template {Record<string, "string" | "number" | "boolean" | "object">} Shape
 * @param {any} message @param {Shape} shape by field; those that may be missing have a "?" at the end of their name
 */
export function checkFields(message, shape) {
  for (const [key, type] of Object.entries(shape)) {
    const name = key.replace(/\?$/, "");
    const value = message[name];
    const optional = key.endsWith("?");
    if (value === undefined || value === null) {
      if (!optional) throw new Mistake(`${message.op}: '${name}' is missing; it is a ${type}`);
    } else if (typeof value !== type) {
      throw new Mistake(`${message.op}: '${name}' is a ${typeof value}; it must be a ${type}`);
    } else if (type === "number" && !Number.isFinite(value)) {
      throw new Mistake(`${message.op}: '${name}' is not a number`);
    }
  }
}
