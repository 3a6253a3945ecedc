// @ts-check
// The levels of the nodes' loggers, as rqt_logger_level sets them.

import { arrange, create, setNote, setText } from "../../ui/elements.js";
import { tool } from "../../ui/toolbar.js";
import { together, say } from "../../ui/words.js";
import { SlidersHorizontal } from "../../vendor/icons.js";
import { PAGE_NODE, isHidden } from "../../graphNames.js";
import { LEVELS } from "./entries.js";

/** @import { Ros } from "../../protocol.js" */

const SRV = "rcl_interfaces/srv";
const SET = "/set_logger_levels";
const GET = "/get_logger_levels";
// A logger without a level of its own has that of the loggers above it.
const UNSET = 0;
const MOST = 200;
let panels = 0;

/** @typedef {{node: string, logger: string, select: HTMLSelectElement, note: HTMLElement, element: HTMLElement}} Row */

export class Levels {
  #ros;
  #wanted;
  /** By logger. @type {Map<string, Row>} */
  #rows = new Map();
  /** The loggers that logged. @type {Set<string>} */
  #loggers = new Set();
  #list = create("ul", "ros-level-list");
  #note = create("p", "ros-note");
  press = tool(say("Levels"), SlidersHorizontal, () => this.#toggle(), say("Which messages nodes log"));
  element = create("div", "ros-logger-levels", this.#list, this.#note);
  #seen = false;

  /** @param {Ros} ros @param {(severity: string) => void} wanted called with a level that a visitor has set */
  constructor(ros, wanted) {
    this.#ros = ros;
    this.#wanted = wanted;
    this.element.hidden = true;
    this.element.id = `ros-logger-levels-${panels += 1}`;
    this.press.setAttribute("aria-expanded", "false");
    this.press.setAttribute("aria-controls", this.element.id);
  }

  /** Follow the graph while the panel is visible. @returns {() => void} end it */
  begin() {
    const look = () => this.#look();
    this.#seen = true;
    this.#ros.graph.addEventListener("change", look);
    look();
    return () => {
      this.#seen = false;
      this.#ros.graph.removeEventListener("change", look);
    };
  }

  /** Show the level of a logger, which has logged. @param {string} logger */
  offer(logger) {
    if (this.#loggers.has(logger) || this.#loggers.size >= MOST) return;
    this.#loggers.add(logger);
    this.#look();
  }

  #toggle() {
    this.element.hidden = !this.element.hidden;
    this.press.setAttribute("aria-expanded", String(!this.element.hidden));
    // Nodes may be restarted, or be given other levels, in the meantime.
    if (this.element.hidden) this.#rows.clear();
    this.#look();
  }

  #look() {
    if (!this.#seen || this.element.hidden) return;
    const { graph } = this.#ros;
    const served = new Set(graph.services().filter(({ servers }) => servers.length).map(({ name }) => name));
    const nodes = graph.nodes().filter((name) => name !== PAGE_NODE && !isHidden(name));
    const able = nodes.filter((name) => this.#known() && served.has(name + SET) && served.has(name + GET));
    const others = nodes.filter((name) => !able.includes(name));
    /** @type {Row[]} */
    const rows = [];
    for (const node of able.slice(0, MOST)) {
      const own = loggerOf(node);
      const below = [...this.#loggers].filter((logger) => logger.startsWith(`${own}.`)).sort();
      for (const logger of [own, ...below]) rows.push(this.#row(node, logger));
    }
    for (const [logger, row] of this.#rows) if (!rows.includes(row)) this.#rows.delete(logger);
    arrange(this.#list, rows.map(({ element }) => element));
    setText(this.#note, describe(nodes, others));
  }

  #known() {
    return [`${SRV}/SetLoggerLevels_Request`, `${SRV}/GetLoggerLevels_Request`].every((type) => this.#ros.types[type]);
  }

  /** @param {string} node @param {string} logger @returns {Row} */
  #row(node, logger) {
    const known = this.#rows.get(logger);
    if (known?.node === node) return known;
    const select = create("select", "", new Option(say("default"), String(UNSET)),
      ...LEVELS.map(([number, name]) => new Option(name, String(number))));
    const note = create("small", "");
    note.setAttribute("role", "status");
    const element = create("li", "", create("label", "", create("span", "ros-name", logger), select), note);
    const row = { node, logger, select, note, element };
    select.addEventListener("change", () => this.#set(row));
    this.#rows.set(logger, row);
    this.#get(row);
    return row;
  }

  /** @param {Row} row */
  async #get({ node, logger, select, note }) {
    try {
      const { levels } = await this.#ros.call(node + GET, `${SRV}/GetLoggerLevels`, { names: [logger] });
      select.value = String(levels[0]?.level ?? UNSET);
      if (!select.value) select.value = String(UNSET);
    } catch (error) {
      setNote(note, error instanceof Error ? error.message : String(error), true);
    }
  }

  /** @param {Row} row */
  async #set(row) {
    const { node, logger, select, note } = row;
    const level = Number(select.value);
    try {
      const request = { levels: [{ name: logger, level }] };
      const { results } = await this.#ros.call(node + SET, `${SRV}/SetLoggerLevels`, request);
      const { successful = false, reason = "" } = results[0] ?? {};
      setNote(note, successful ? "" : reason || say("refused"), !successful);
      const severity = LEVELS.find(([number]) => number === level)?.[1];
      if (successful && severity) this.#wanted(severity);
    } catch (error) {
      setNote(note, error instanceof Error ? error.message : String(error), true);
    }
    this.#get(row);
  }
}

/** The logger of a node: "/arm/driver" logs as "arm.driver". @param {string} node */
function loggerOf(node) {
  return node.slice(1).replaceAll("/", ".");
}

/** @param {string[]} nodes @param {string[]} others which offer no services */
function describe(nodes, others) {
  if (!nodes.length) return say("No nodes now. They appear when they start.");
  if (!others.length) return "";
  const named = others.length > 5 ? say("{} nodes", others.length) : together(others);
  return say("No logger services: {}. A node offers them if its program sets the option enable_logger_service.", named);
}
