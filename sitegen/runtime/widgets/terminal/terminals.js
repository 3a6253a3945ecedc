// @ts-check
// The terminals of a widget, each in a tab.

import { button, create, enable, toggle } from "../../ui/elements.js";
import { watchColours } from "../../ui/colours.js";
import { fullScreenButton } from "../../ui/fullScreen.js";
import { tool } from "../../ui/toolbar.js";
import { say } from "../../ui/words.js";
import { ArrowDown, ArrowUp, Plus, X } from "../../vendor/icons.js";
import { Bags } from "../../terminal/bags.js";
import { Interfaces } from "../../terminal/interfaces.js";
import { History } from "../../terminal/line/history.js";
import { Session } from "../../terminal/session.js";

/** @import { Files } from "../../terminal/interfaces.js" */
/** @import { Ros } from "../../protocol.js" */
/** @import { Icon } from "../../ui/toolbar.js" */

/** The terminals of one widget, at most. */
const MOST = 8;
/**
 * Keys that a phone's keyboard lacks: what is on them, what they do, and what a terminal sends for them.
 * @type {[string | Icon, string, string][]}
 */
const KEYS = [
  ["Tab", say("Complete"), "\t"], ["Ctrl-C", say("Interrupt"), "\x03"],
  [ArrowUp, say("Earlier line"), "\x1b[A"], [ArrowDown, say("Later line"), "\x1b[B"],
  [turned(ArrowUp, -90), say("Cursor left"), "\x1b[D"], [turned(ArrowUp, 90), say("Cursor right"), "\x1b[C"],
];

/** @param {Icon} icon @param {number} degrees clockwise @returns {Icon} */
function turned(icon, degrees) {
  return icon.map(([tag, attributes]) => [tag, { ...attributes, transform: `rotate(${degrees} 12 12)` }]);
}

/**
 * `run` is the first line; `bags` are the addresses of the bags that the page plays, by path; the others are those of all
 * interfaces.
 * @typedef {{run?: string, bags?: Record<string, string>} & Files} Options
 */

/**
 * Open a terminal in an element.
 * @param {HTMLElement} element @param {Ros} ros @param {Options} options
 * @param {() => void} [emptied] called when a visitor closes the last terminal; without it, another one opens
 * @returns {Opened}
 */
export function open(element, ros, { run, bags = {}, ...files }, emptied) {
  const terminals = new Terminals(element, ros, new Bags(ros, bags), new Interfaces(ros.types, files), emptied);
  const first = terminals.add();
  if (run) first.enter(run);
  return terminals;
}

/** @typedef {{enter: (text: string) => void, close: () => void}} Opened `enter` runs a line, and gives it the focus */

/** @typedef {{session: Session, tab: HTMLButtonElement, screen: HTMLElement}} Open */

class Terminals {
  #element;
  #ros;
  /** @type {Open[]} */
  #open = [];
  /** @type {Open | undefined} */
  #shown;
  #number = 0;
  #loud = false;
  #files = new Map();
  #bags;
  #interfaces;
  #emptied;
  #history = new History();
  #tabs = create("div", "ros-tabs");
  #add = tool(say("New terminal"), Plus, () => {
    this.add();
    this.#shown?.session.focus();
  });
  #close = tool(say("Close terminal"), X, () => this.#remove());
  #control = button("Ctrl", "", () => this.#hold(this.#control.ariaPressed !== "true"));
  #unwatch;
  #observer = new ResizeObserver(() => this.#shown?.session.fit());

  /**
   * @param {HTMLElement} element @param {Ros} ros @param {Bags} bags @param {Interfaces} interfaces
   * @param {(() => void) | undefined} emptied
   */
  constructor(element, ros, bags, interfaces, emptied) {
    this.#emptied = emptied;
    this.#element = element;
    this.#interfaces = interfaces;
    this.#bags = bags;
    this.#ros = ros;
    this.#tabs.setAttribute("role", "tablist");
    this.#tabs.setAttribute("aria-label", say("Terminals"));
    const loud = toggle(say("Screen reader"), (on) => {
      this.#loud = on;
      for (const { session } of this.#open) session.readAloud(on);
    });
    loud.title = say("Screen readers read the output. Press Esc, then Tab to leave the terminal.");
    const controls = create("div", "ros-controls", this.#add, this.#close, fullScreenButton(element));
    const keys = create("div", "ros-keys", this.#control, ...KEYS.map(([sign, name, data]) => {
      const press = () => this.#shown?.session.press(data);
      const key = typeof sign === "string" ? button(sign, "", press) : tool(name, sign, press);
      key.title = name;
      return key;
    }));
    // The keyboard of the phone stays where it is.
    keys.addEventListener("pointerdown", (event) => event.preventDefault());
    this.#control.title = say("Type the next letter with Ctrl");
    this.#hold(false);
    const title = create("span", "ros-title", say("Terminal"));
    element.replaceChildren(create("div", "ros-bar", title, this.#tabs, loud, controls), keys);
    this.#unwatch = watchColours(() => {
      for (const { session } of this.#open) session.paint(coloursOf(element));
    });
  }

  /** Open another terminal, and show it. */
  add() {
    const number = ++this.#number;
    const screen = create("div", "ros-screen");
    screen.id = `${this.#element.id}-${number}`;
    screen.setAttribute("role", "tabpanel");
    screen.setAttribute("aria-label", say("Terminal {}", number));
    this.#element.insertBefore(screen, this.#element.lastElementChild);
    const tab = button(String(number), "", () => {
      this.#show(opened);
      opened.session.focus();
    });
    tab.setAttribute("role", "tab");
    tab.setAttribute("aria-label", say("Terminal {}", number));
    tab.setAttribute("aria-controls", screen.id);
    this.#tabs.append(tab);
    for (const other of this.#open) other.screen.hidden = true;
    const session = new Session(screen, this.#ros, {
      files: this.#files, bags: this.#bags, interfaces: this.#interfaces, history: this.#history, colours: coloursOf(this.#element),
      size: parseFloat(getComputedStyle(screen).fontSize),
    });
    session.readAloud(this.#loud);
    session.released = () => {
      this.#control.ariaPressed = "false";
    };
    const opened = { session, tab, screen };
    this.#open.push(opened);
    this.#observer.observe(screen);
    this.#show(opened);
    return session;
  }

  /** Run a line in the terminal that is shown. @param {string} text */
  enter(text) {
    this.#shown?.session.enter(text);
    this.#shown?.session.focus();
  }

  close() {
    this.#unwatch();
    this.#observer.disconnect();
    for (const { session } of this.#open) session.close();
    this.#element.replaceChildren();
  }

  /** Close the terminal that is shown; the last one is replaced, or all are gone. */
  #remove() {
    const gone = this.#shown;
    if (!gone) return;
    if (this.#emptied && this.#open.length === 1) {
      this.#emptied();
      return;
    }
    gone.session.close();
    gone.tab.remove();
    gone.screen.remove();
    const at = this.#open.indexOf(gone);
    this.#open.splice(at, 1);
    const next = this.#open[Math.min(at, this.#open.length - 1)];
    if (next) this.#show(next);
    else this.add();
    this.#shown?.session.focus();
  }

  /** Let the next letter be typed with Ctrl, or not. @param {boolean} on */
  #hold(on) {
    this.#control.ariaPressed = String(on);
    this.#shown?.session.holdControl(on);
  }

  /** @param {Open} opened */
  #show(opened) {
    this.#shown = opened;
    for (const one of this.#open) {
      one.screen.hidden = one !== opened;
      one.tab.ariaSelected = String(one === opened);
      one.tab.tabIndex = one === opened ? 0 : -1;
    }
    this.#tabs.hidden = this.#open.length < 2;
    enable([[this.#add, this.#open.length < MOST], [this.#close, true]]);
    opened.session.fit();
  }
}

/** The colours of the theme, for xterm. @param {HTMLElement} element */
function coloursOf(element) {
  const probe = create("span", "");
  element.append(probe);
  const colour = (/** @type {string} */ name) => {
    probe.style.color = `var(--${name})`;
    return getComputedStyle(probe).color;
  };
  const found = {
    background: colour("terminal"), foreground: colour("terminal-text"), cursor: colour("terminal-accent"),
    cursorAccent: colour("terminal"), selectionBackground: colour("terminal-line"),
    red: colour("severity-error"), green: colour("severity-debug"), yellow: colour("severity-warn"),
    blue: colour("terminal-accent"), cyan: colour("terminal-accent"), brightGreen: colour("severity-debug"),
  };
  probe.remove();
  return found;
}
