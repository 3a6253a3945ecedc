// @ts-check
// What the page and the worker of a connection say to each other.

/** @import { MessageType } from "../protocol.js" */
/** @import { People } from "./people.js" */

/**
 * `connect:` of site.yaml. Names are patterns: `*` stands for part of a name between two slashes, `**` for any.
 * @typedef {{addresses: string[], autoconnect?: boolean, namespace?: string, rates?: Record<string, number>,
 *   send?: Names, receive?: Names}} Connect `send` is what the page's nodes offer to the others, `receive` what they
 *   get; `rates` are the most messages per second of topics that the page gets
 * @typedef {{topics?: string[], services?: string[], actions?: string[]}} Names
 *
 * From the page: join the graph behind an address, or leave it.
 * @typedef {{op: "connect", address: string, connect: Connect, hashes: Record<string, string>,
 *   key: string}
 *   | {op: "disconnect"}
 *   | {op: "types", types: Record<string, MessageType>}} ToGateway
 *
 * To the page. `retry` is the time until the next try (ms). `offset` is the time of the gateway minus that of the page
 * (ms). `kept` says what stays out, and why; `note` what failed.
 * @typedef {{op: "state", state: State, retry?: number, reason?: string}
 *   | {op: "joined", rmw: string, domain: number | null, distribution: string}
 *   | {op: "nodes", nodes: string[]}
 *   | {op: "kept", name: string, reason: string}
 *   | {op: "note", name: string, reason: string}
 *   | {op: "differs", type: string, name: string}
 *   | {op: "types", types: Record<string, MessageType>}
 *   | {op: "describe", types: string[]}
 *   | {op: "clock", offset: number}
 *   | {op: "people", people: People}
 *   | {op: "turn"} & Turn
 *   | {op: "until", seconds: number | null}} FromGateway
 * @typedef {{now: string, nowLeft: number | null, mineIn: number | null, mineLeft: number | null}} Turn whose turn it is
 *   at the gateway; times in seconds. `mineIn` is 0 in the visitor's own turn, and null without an appointment
 * @typedef {"connecting" | "key" | "connected" | "late" | "lost" | "refused" | "ended" | "off"} State `late`
 *   if the gateway does not answer, but the connection may still be there
 *
 * What a connection uses of a WebSocket.
 * @typedef {Pick<WebSocket, "readyState" | "bufferedAmount" | "send" | "close"> & {
 *   onmessage: ((event: MessageEvent) => void) | null, onclose: ((event: CloseEvent) => void) | null}} Socket
 */

export {};
