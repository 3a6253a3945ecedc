// @ts-check
// The services of the page, and a form to call one.

import { isShown } from "../graphNames.js";
import { arrange, button, create, setText, toggle } from "../ui/elements.js";
import { whileSeen } from "../ui/looking.js";
import { createForm } from "../messages/form.js";
import { toYaml } from "../messages/yaml.js";
import { say } from "../ui/words.js";

/** @import { Ros } from "../protocol.js" */

const NONE = say("No services now. They appear when nodes start.");
const ALL_HIDDEN = say("Only hidden services now.");
// After this time (ms) a call is given up.
const TIMEOUT = 5000;

/**
 * @typedef {{name: string, types: string[], servers: string[]}} Service
 * @typedef {{element: HTMLElement, pick: HTMLButtonElement, type: HTMLElement, servers: HTMLElement}} Row
 */

/**
 * Show the services, or those named in `show` only.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{show?: string[] | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { show }) {
  let hidden = false;
  let chosen = "";
  /** @type {Map<string, Row>} */
  const rows = new Map();

  const bar = create("div", "ros-bar", create("span", "ros-title", say("Services")));
  const all = toggle(say("Show hidden"), (on) => {
    hidden = on;
    look();
  });
  if (!show) bar.append(all);
  const body = create("ul", "ros-picks");
  const hint = create("p", "ros-hint");
  const list = create("div", "ros-list", body, hint);
  const call = createCall(ros);
  element.replaceChildren(bar, create("div", "ros-split", list, call.element));

  /** @param {string} name */
  const choose = (name) => {
    chosen = name;
    for (const [service, { pick }] of rows) pick.setAttribute("aria-pressed", String(service === name));
    look();
  };

  const look = () => {
    const there = ros.graph.services();
    const services = listed(there, show ?? null, hidden);
    const names = services.map(({ name }) => name);
    for (const name of rows.keys()) if (!names.includes(name)) rows.delete(name);
    for (const { name, types, servers } of services) {
      let row = rows.get(name);
      if (!row) {
        row = createRow(name, () => choose(name));
        row.pick.setAttribute("aria-pressed", String(name === chosen));
        rows.set(name, row);
      }
      setText(row.type, types.join(", "));
      setText(row.servers, servers.length ? say("served by {}", servers.join(", ")) : say("no server now"));
      row.element.classList.toggle("ros-idle", !servers.length);
    }
    arrange(body, names.flatMap((name) => rows.get(name)?.element ?? []));
    hint.hidden = names.length > 0;
    setText(hint, there.length ? ALL_HIDDEN : NONE);
    const service = there.find(({ name }) => name === chosen);
    call.show(chosen, service?.types[0] ?? "", service?.servers.length ?? 0);
  };

  const first = show?.[0] ?? "";
  if (first) choose(first);
  const read = () => ({ service: chosen === first ? "" : chosen, hidden, request: call.typed() });
  ros.keep(element, { service: "string", hidden: "boolean", request: "object" }, read, (state, odd) => {
    call.fill(state.service ?? first, state.request, odd);
    if (state.service) choose(state.service);
    if (state.hidden) all.querySelector("input")?.click();
  });
  const unlook = whileSeen(element, () => {
    look();
    ros.graph.addEventListener("change", look);
    return () => ros.graph.removeEventListener("change", look);
  });
  return () => {
    unlook();
    element.replaceChildren();
  };
}

/** @param {Service[]} services @param {string[] | null} show @param {boolean} hidden @returns {Service[]} */
function listed(services, show, hidden) {
  if (show) {
    return show.map((name) => services.find((s) => s.name === name) ?? { name, types: [], servers: [] });
  }
  return services.filter(({ name }) => hidden || isShown(name));
}

/** @param {string} name @param {() => void} choose @returns {Row} */
function createRow(name, choose) {
  const pick = button(name, "ros-pick", choose);
  const type = create("small", "");
  const servers = create("small", "");
  return { element: create("li", "", pick, type, servers), pick, type, servers };
}

/**
 * The form to call one service, with its answer. It stays as it is typed while servers come and go. `fill`
 * types a request as soon as the form of that service is there, and calls `odd` if it does not fit.
 * @param {Ros} ros
 * @returns {{element: HTMLElement, show(service: string, type: string, servers: number): void,
 *   typed(): any, fill(service: string, request: any, odd: () => void): void}}
 */
function createCall(ros) {
  const title = create("span", "ros-name");
  const kind = create("span", "ros-type");
  const bar = create("div", "ros-bar", create("div", "ros-node", title, kind));
  const place = create("div", "ros-place");
  const send = create("button", "ros-send", say("Call"));
  const note = create("p", "ros-note");
  note.setAttribute("role", "status");
  const answer = create("pre", "ros-answer");
  answer.tabIndex = 0;
  answer.setAttribute("aria-label", say("response"));
  const form = create("form", "ros-call", place, create("div", "ros-controls", send), note, answer);
  form.noValidate = true;
  const hint = create("p", "ros-hint", say("Choose a service to call it"));
  const element = create("div", "ros-detail", bar, form, hint);

  let shown = "";
  let service = "";
  let type = "";
  let calling = 0;
  /** @type {ReturnType<typeof createForm> | undefined} */
  let made;
  /** What a link says is typed, until there is a form for it. */
  let given = { service: "", request: /** @type {any} */ (undefined), odd: () => {} };

  /** @param {string} text @param {boolean} [wrong] */
  const tell = (text, wrong = false) => {
    note.classList.toggle("ros-wrong", wrong);
    setText(note, text);
  };

  const build = () => {
    made = undefined;
    calling = 0;
    answer.textContent = "";
    tell("");
    place.replaceChildren();
    if (!type) return;
    try {
      made = createForm(`${type}_Request`, ros.types);
      place.replaceChildren(made.element);
      if (given.request && given.service === service) {
        if (!made.fill(given.request)) given.odd();
        given.request = undefined;
      }
    } catch (error) {
      tell(say("This service cannot be called from here: {}", error instanceof Error ? error.message : error), true);
    }
  };

  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    const request = made?.read();
    if (!request) return;
    const mine = ++calling;
    const [name, its] = [service, type];
    answer.textContent = "";
    tell(say("Waiting for the response…"));
    const begun = performance.now();
    try {
      const response = await ros.call(name, its, request, TIMEOUT);
      if (mine !== calling || service !== name) return;
      answer.textContent = toYaml(response, `${its}_Response`, ros.types);
      tell(say("{} responded in {} ms", name, (performance.now() - begun).toFixed(1)));
    } catch (error) {
      if (mine !== calling || service !== name) return;
      tell(error instanceof Error ? error.message : String(error), true);
    }
  });

  return {
    element,
    typed: () => (given.service === service && given.request) || made?.typed(),
    fill(name, request, odd) {
      given = { service: name, request, odd };
    },
    show(name, itsType, servers) {
      service = name;
      // A service that goes leaves its form, so that what was typed is there when it returns.
      if (itsType || !shown.startsWith(`${name} `)) type = itsType;
      if (shown !== `${name} ${type}`) {
        shown = `${name} ${type}`;
        build();
      }
      setText(title, name);
      setText(kind, type);
      bar.hidden = !name;
      form.hidden = !name || !type;
      send.disabled = !made;
      hint.hidden = !form.hidden;
      setText(hint, name ? say("No server for {} now. Start the node that provides it.", name) : say("Choose a service to call it"));
      send.classList.toggle("ros-idle", servers === 0);
    },
  };
}
