// @ts-check
// Publish on a topic what is typed into a form, once or again and again.

import { isShown } from "../graphNames.js";
import { button, create, setText } from "../ui/elements.js";
import { whileSeen } from "../ui/looking.js";
import { createForm } from "../messages/form.js";
import { say } from "../ui/words.js";

/** @import { Publisher, Ros } from "../protocol.js" */

// Messages a second.
const SLOWEST = 0.1;
const FASTEST = 100;

/**
 * Publish on `topic`, or on one that the visitor chooses; `type` is needed where no node uses it yet.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{topic?: string | null, type?: string | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { topic: fixed, type: declared }) {
  let topic = fixed ?? "";
  let built = "";
  let count = 0;
  /** @type {ReturnType<typeof createForm> | undefined} */
  let made;
  /** What a link says is typed, until there is a form for it. */
  let given = { message: /** @type {any} */ (undefined), odd: () => {} };
  /** @type {Publisher | undefined} */
  let publisher;
  /** @type {ReturnType<typeof setInterval> | undefined} */
  let timer;

  const choice = create("select", "");
  choice.setAttribute("aria-label", say("topic"));
  choice.addEventListener("change", () => {
    topic = choice.value;
    look();
  });
  const title = create("span", "ros-name");
  const kind = create("span", "ros-type");
  const heading = create("div", "ros-node", fixed ? title : create("span", "ros-title", say("Publish")));
  if (fixed) heading.append(kind);
  const bar = create("div", "ros-bar", heading);
  if (!fixed) bar.append(choice);

  const place = create("div", "ros-place");
  const once = create("button", "ros-send", say("Publish once"));
  const rate = create("input", "ros-rate");
  rate.value = "1";
  rate.inputMode = "decimal";
  rate.setAttribute("aria-label", say("messages per second (Hz)"));
  const repeat = button(say("Repeat"), "ros-start", () => (timer === undefined ? begin() : stop()));
  const note = create("p", "ros-note");
  note.setAttribute("role", "status");
  const every = create("label", "ros-every", rate, "Hz");
  const controls = create("div", "ros-controls", once, repeat, every);
  const form = create("form", "ros-call", place, controls, note);
  form.noValidate = true;
  const hint = create("p", "ros-hint");
  element.replaceChildren(bar, form, hint);

  /** @param {string} text @param {boolean} [wrong] */
  const tell = (text, wrong = false) => {
    note.classList.toggle("ros-wrong", wrong);
    setText(note, text);
  };

  /** Publish what the form holds; false where that is no message. */
  const send = () => {
    const message = made?.read();
    if (!message) return false;
    try {
      publisher ??= ros.advertise(topic, typeOf());
      publisher.publish(message);
    } catch (error) {
      tell(say("Not published: {}", error instanceof Error ? error.message : error), true);
      return false;
    }
    count++;
    tell(count === 1 ? say("1 message published") : say("{} messages published", count));
    return true;
  };

  const stop = () => {
    clearInterval(timer);
    timer = undefined;
    show();
  };
  const begin = () => {
    const hertz = Number(rate.value.trim().replace(",", "."));
    const wrong = !(hertz >= SLOWEST && hertz <= FASTEST);
    rate.toggleAttribute("aria-invalid", wrong);
    if (wrong) {
      tell(say("The rate must be a number from {} to {} Hz", SLOWEST, FASTEST), true);
      rate.focus();
      return;
    }
    if (!send()) return;
    timer = setInterval(() => {
      if (!send()) stop();
    }, 1000 / hertz);
    show();
  };
  const end = () => {
    stop();
    publisher?.close();
    publisher = undefined;
  };

  const typeOf = () => {
    if (declared) return declared;
    const types = ros.graph.topics().find(({ name }) => name === topic)?.types ?? [];
    return types.find((type) => ros.types[type]) ?? types[0] ?? "";
  };

  const show = () => {
    const repeating = timer !== undefined;
    setText(repeat, repeating ? say("Stop") : say("Repeat"));
    repeat.className = repeating ? "ros-stop" : "ros-start";
    rate.disabled = repeating;
  };

  /** Begin anew, with the form of the topic's type. @param {string} type */
  const build = (type) => {
    end();
    count = 0;
    tell("");
    made = undefined;
    place.replaceChildren();
    if (!type) return;
    try {
      made = createForm(type, ros.types);
      place.replaceChildren(made.element);
      if (given.message && !made.fill(given.message)) given.odd();
      given.message = undefined;
    } catch (error) {
      tell(say("Publishing is not possible here: {}", error instanceof Error ? error.message : error), true);
    }
  };

  const look = () => {
    if (!fixed) topic = offer(choice, ros, topic);
    // A topic that goes leaves its form: what was typed there may be published again.
    const type = typeOf() || (built.startsWith(`${topic} `) ? built.slice(topic.length + 1) : "");
    if (`${topic} ${type}` !== built) {
      build(type);
      built = `${topic} ${type}`;
    }
    setText(title, topic);
    setText(kind, type);
    form.hidden = !type;
    once.disabled = !made;
    repeat.disabled = !made;
    hint.hidden = Boolean(type);
    setText(hint, topic
      ? say("No node uses {} now, so its type is unknown. Start a node that uses it.", topic)
      : say("No topics to publish on. They appear when nodes start."));
  };

  form.addEventListener("submit", (event) => {
    event.preventDefault();
    send();
  });
  show();
  const read = () => ({
    topic: fixed ? "" : topic, message: given.message ?? made?.typed(), rate: rate.value === "1" ? "" : rate.value,
  });
  ros.keep(element, { topic: "string", message: "object", rate: "string" }, read, (state, odd) => {
    if (!fixed && state.topic) topic = state.topic;
    given = { message: state.message, odd };
    if (state.rate) rate.value = state.rate;
  });
  const unlook = whileSeen(element, () => {
    look();
    ros.graph.addEventListener("change", look);
    return () => ros.graph.removeEventListener("change", look);
  });
  return () => {
    unlook();
    end();
    element.replaceChildren();
  };
}

/**
 * Offer the topics of which the page knows the type, and return which is chosen.
 * @param {HTMLSelectElement} choice @param {Ros} ros @param {string} chosen
 */
function offer(choice, ros, chosen) {
  const names = ros.graph.topics()
    .filter(({ name, types }) => isShown(name) && types.some((t) => ros.types[t]))
    .map(({ name }) => name);
  if (chosen && !names.includes(chosen)) names.push(chosen);
  if (names.join() !== [...choice.options].map(({ value }) => value).join()) {
    choice.replaceChildren(...names.map((name) => new Option(name)));
  }
  choice.hidden = names.length === 0;
  choice.value = chosen || (names[0] ?? "");
  return choice.value;
}
