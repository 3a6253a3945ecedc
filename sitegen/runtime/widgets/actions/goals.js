// @ts-check
// The goals of an action, the latest first: state, feedback, result and a button to cancel.

import { isFinal } from "../../messages/actionClient.js";
import { toYaml } from "../../messages/yaml.js";
import { arrange, button, create, setText } from "../../ui/elements.js";
import { say } from "../../ui/words.js";

/** @import { ActionClient, Goal, GoalState } from "../../messages/actionClient.js" */
/** @import { MessageType } from "../../protocol.js" */

/** @type {Record<GoalState, string>} */
const STATES = {
  sending: say("sending"),
  rejected: say("rejected"),
  lost: say("no result"),
  unknown: say("unknown"),
  accepted: say("accepted"),
  executing: say("executing"),
  canceling: say("canceling"),
  succeeded: say("succeeded"),
  canceled: say("canceled"),
  aborted: say("aborted"),
};

export class GoalList {
  #client;
  #type;
  #types;
  #tell;
  /** @type {Map<string, Row>} */
  #rows = new Map();
  #frame = 0;
  #changed = (/** @type {Event} */ event) => {
    const goal = /** @type {CustomEvent<Goal>} */ (event).detail;
    if (goal.own && this.#rows.get(goal.id)?.state !== goal.state) this.#announce(goal);
    this.#frame ||= requestAnimationFrame(() => this.#draw());
  };
  element = create("ul", "ros-goal-list");

  /**
   * @param {ActionClient} client @param {string} type @param {Record<string, MessageType>} types
   * @param {(text: string, wrong: boolean) => void} tell
   */
  constructor(client, type, types, tell) {
    this.#client = client;
    this.#type = type;
    this.#types = types;
    this.#tell = tell;
    this.element.setAttribute("aria-label", say("Goals"));
    client.addEventListener("change", this.#changed);
  }

  close() {
    this.#client.removeEventListener("change", this.#changed);
    cancelAnimationFrame(this.#frame);
  }

  /** @param {Goal} goal */
  #announce({ id, state, fault }) {
    const text = say("Goal {}: {}", short(id), STATES[state]);
    this.#tell(fault ? `${text}: ${fault}` : text, state === "rejected" || state === "lost" || state === "aborted");
  }

  #draw() {
    this.#frame = 0;
    const { goals } = this.#client;
    for (const id of this.#rows.keys()) if (!goals.has(id)) this.#rows.delete(id);
    for (const [id, goal] of goals) {
      const row = this.#rows.get(id) ?? new Row(goal, () => this.#cancel(goal));
      this.#rows.set(id, row);
      row.show(goal, this.#type, this.#types);
    }
    arrange(this.element, [...goals.keys()].reverse().map((id) => /** @type {Row} */ (this.#rows.get(id)).element));
  }

  /** @param {Goal} goal */
  async #cancel(goal) {
    try {
      await this.#client.cancel(goal);
    } catch (error) {
      const reason = error instanceof Error ? error.message : error;
      this.#tell(say("Goal {} is not canceled: {}", short(goal.id), reason), true);
    }
  }
}

class Row {
  #state = create("span", "ros-goal-state");
  #cancel;
  #feedback = create("pre", "ros-answer");
  #result = create("pre", "ros-answer");
  #parts;
  element;
  /** @type {GoalState | undefined} */
  state;

  /** @param {Goal} goal @param {() => void} cancel */
  constructor({ id, own }, cancel) {
    this.#cancel = button(say("Cancel"), "", cancel);
    this.#cancel.setAttribute("aria-label", say("Cancel goal {}", short(id)));
    const name = create("b", "ros-goal-name", short(id));
    name.title = id;
    const head = create("div", "ros-goal-head", name, this.#state, this.#cancel);
    if (!own) name.append(" ", create("small", "", say("of another node")));
    /** @type {[HTMLPreElement, HTMLElement, string][]} */
    this.#parts = [
      [this.#feedback, create("p", "ros-label", say("Feedback")), say("feedback of goal {}", short(id))],
      [this.#result, create("p", "ros-label", say("Result")), say("result of goal {}", short(id))],
    ];
    this.element = create("li", "ros-goal", head);
    for (const [text, label, name] of this.#parts) {
      text.tabIndex = 0;
      text.setAttribute("aria-label", name);
      label.hidden = true;
      this.element.append(label, text);
    }
  }

  /** @param {Goal} goal @param {string} type of the action @param {Record<string, MessageType>} types */
  show({ state, feedback, result, fault }, type, types) {
    this.state = state;
    this.element.dataset.state = state;
    setText(this.#state, fault ? `${STATES[state]}: ${fault}` : STATES[state]);
    // Hiding it would take the keyboard focus to the start of the page.
    if (this.#cancel === document.activeElement && isFinal(state)) this.#feedback.focus();
    this.#cancel.hidden = isFinal(state) || state === "sending";
    setText(this.#feedback, feedback === undefined ? "" : toYaml(feedback, `${type}_Feedback`, types));
    setText(this.#result, result === undefined ? "" : toYaml(result, `${type}_Result`, types));
    for (const [text, label] of this.#parts) label.hidden = !text.textContent;
  }
}

/** A goal id as people tell it from others. @param {string} id */
function short(id) {
  return id.slice(0, 6);
}
