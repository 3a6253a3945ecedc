// @ts-check
// Who else has joined the gateway: how many, and a list to open.

import { create, setText } from "../../ui/elements.js";
import { say, together } from "../../ui/words.js";

/** @import { People, Visitor } from "../../gateway/people.js" */

export class PeopleList {
  #summary = create("summary", "");
  #rows = create("tbody", "");
  #more = create("p", "ros-connect-note");
  element = create(
    "details", "ros-connect-people", this.#summary, create("div", "ros-connect-table", table(this.#rows)), this.#more);

  /** @param {People} people */
  show({ pages, more, others }) {
    const count = pages.length + more;
    const clients = [count === 1 ? say("1 page") : say("{} pages", count)];
    if (others > 0) clients.push(others === 1 ? say("1 other client") : say("{} other clients", others));
    setText(this.#summary, say("Here now: {}", together(clients)));
    // In a long list, visitors see themselves at once.
    const first = pages.filter(({ you }) => you);
    this.#rows.replaceChildren(...[...first, ...pages.filter(({ you }) => !you)].map(row));
    setText(this.#more, more > 0 ? say("… and {} more", more) : "");
    this.element.hidden = false;
  }

  /** Show nobody, as the gateway is not there or does not tell. */
  hide() {
    this.element.hidden = true;
    this.#rows.replaceChildren();
  }
}

/** @param {HTMLElement} rows */
function table(rows) {
  const titles = [say("Who"), say("Namespace"), say("Nodes"), say("Since")].map((text) => {
    const title = create("th", "", text);
    title.scope = "col";
    return title;
  });
  return create("table", "", create("thead", "", create("tr", "", ...titles)), rows);
}

/** @param {Visitor} visitor */
function row({ id, name, namespace, nodes, since, you }) {
  // Names may be of any script, in any direction.
  const who = create("th", "", create("bdi", "", name || say("visitor {}", id)));
  who.scope = "row";
  if (you) who.append(" ", create("em", "", say("(you)")));
  const moment = new Date(since);
  const time = create("time", "", moment.toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" }));
  time.dateTime = moment.toISOString();
  time.title = moment.toLocaleString();
  const facts = [namespace || "–", String(nodes), time].map((fact) => create("td", "", fact));
  return create("tr", "", who, ...facts);
}
