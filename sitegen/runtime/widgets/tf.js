// @ts-check
// The tree of frames, who publishes each and how often, and the transform between two of them.

import { create, setText } from "../ui/elements.js";
import { fullScreenButton } from "../ui/fullScreen.js";
import { whileNear } from "../ui/looking.js";
import { Toolbar } from "../ui/toolbar.js";
import { say } from "../ui/words.js";
import { FrameEcho } from "./tf/echo.js";
import { FrameSources } from "./tf/sources.js";
import { FrameTable } from "./tf/table.js";
import { Transforms } from "./tf/transforms.js";
import { FrameTree } from "./tf/tree.js";

/** @import { MessageInfo, Ros } from "../protocol.js" */

const TF = "tf2_msgs/msg/TFMessage";
// Rates and transforms are read as often as people read them (ms).
const PERIOD = 250;
/** More frames than these are not drawn. */
const MOST = 200;

/**
 * Show the frames, and the pose of `frame` in `reference`.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{reference?: string | null, frame?: string | null}} options
 * @returns {() => void} unmount
 */
export function mount(element, ros, { reference, frame }) {
  const transforms = new Transforms();
  const sources = new FrameSources(ros);
  const tree = new FrameTree();
  const table = new FrameTable();
  const echo = new FrameEcho(reference ?? "", frame ?? "");
  const controls = new Toolbar(tree.tools, [fullScreenButton(element)]);
  const bar = create("div", "ros-bar", create("span", "ros-title", say("Frames")), controls.element);
  const hint = create("p", "ros-hint");
  const note = create("p", "ros-note");
  element.replaceChildren(bar, tree.element, hint, note, table.element, echo.element);

  let drawn = -1;
  const draw = () => {
    const frames = transforms.frames().slice(0, MOST);
    if (drawn !== transforms.version) {
      drawn = transforms.version;
      tree.draw(frames, transforms);
      echo.offer(transforms.frames());
      setText(note, transforms.frames().length > MOST ? say("the first {} frames", MOST) : "");
    }
    hint.hidden = frames.length > 0;
    setText(hint, ros.types[TF] ? say("No transforms on /tf now.") : say("no node on this page uses {}", TF));
    table.show(frames, transforms, sources);
    echo.show(transforms);
  };
  ros.keep(element, { reference: "string", frame: "string" }, () => echo.kept(), (state) => echo.restore(state));
  const unlook = whileNear(element, () => {
    /** @type {(() => void)[]} */
    const ends = [];
    const take = (/** @type {boolean} */ fixed) => (/** @type {any} */ message, /** @type {MessageInfo} */ info) => {
      for (const stamped of message.transforms) {
        transforms.add(stamped, fixed);
        sources.add(stamped, info);
      }
    };
    const look = () => {
      // A bag may bring the type later.
      if (!ends.length && ros.types[TF]) {
        ends.push(
          ros.subscribe("/tf", TF, take(false), { depth: 1000 }),
          ros.subscribe("/tf_static", TF, take(true), { depth: 1000, reliable: true, transientLocal: true }),
        );
      }
      draw();
    };
    look();
    const timer = setInterval(look, PERIOD);
    return () => {
      clearInterval(timer);
      for (const end of ends) end();
    };
  });
  return () => {
    unlook();
    tree.close();
    element.replaceChildren();
  };
}
