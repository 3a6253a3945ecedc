// @ts-check
// The robot and its world in 3D: frames, models, sensors and markers, as RViz shows them.

import { download } from "../ui/download.js";
import { button, create, setNote } from "../ui/elements.js";
import { fullScreenButton } from "../ui/fullScreen.js";
import { whileSeen } from "../ui/looking.js";
import { say } from "../ui/words.js";
import { DisplayList } from "./3d/displayList.js";
import { FrameChooser } from "./3d/frameChooser.js";
import { createStage } from "./3d/stage.js";
import { Tools } from "./3d/tools.js";
import { World } from "./3d/world.js";

/** @import { Ros } from "../protocol.js" */
/** @import { Shared } from "../protocol.js" */
/** @import { Stage, View } from "./3d/stage.js" */

/**
 * Show a 3D view.
 * @param {HTMLElement} element
 * @param {Ros} ros
 * @param {{frame?: string, displays?: Record<string, any>[], view?: View, top?: boolean, background?: string, tools?: string[],
 *   resources?: Record<string, string>}} options `displays` each have a `kind` and its options; without them, the view
 *   shows what there is. `resources` maps the URLs of meshes to addresses
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const title = create("span", "ros-title", say("3D view"));
  const stage = createStage(say("3D view; arrow keys turn it, with Shift they move it, + and - zoom, 0 shows everything"));
  if (typeof stage === "string") {
    const note = create("p", "ros-empty");
    setNote(note, stage, true);
    element.replaceChildren(create("div", "ros-bar", title), note);
    return () => element.replaceChildren();
  }
  return show(element, ros, options, stage, title);
}

/**
 * @param {HTMLElement} element @param {Ros} ros @param {any} options @param {Stage} stage @param {HTMLElement} title
 */
function show(element, ros, options, stage, title) {
  const world = new World(ros, stage, options);
  const frames = new FrameChooser(world);
  const list = new DisplayList(world);
  const tools = new Tools(ros, stage, world, options.tools);
  const top = button(say("Top"), "", () => {
    stage.top = !stage.top;
    stage.fit();
    press();
  });
  const press = () => top.setAttribute("aria-pressed", String(stage.top));
  const fit = button(say("Fit"), "", () => {
    stage.chosen = false;
    stage.fit();
  });
  top.title = say("Look straight down");
  fit.title = say("Show everything");
  const save = button(say("Picture"), "", async () => {
    const blob = await stage.picture();
    if (blob) download(blob, "3d.png");
  });
  save.title = say("Save a picture");
  const controls = create("div", "ros-controls", frames.element, ...tools.buttons, top, fit, save, fullScreenButton(element));
  const blind = create("p", "ros-scene-lost",
    say("The browser has stopped drawing this view: the graphics card was reset, or too many views are open."));
  blind.setAttribute("role", "alert");
  blind.hidden = true;
  stage.element.append(tools.note, blind);
  stage.hint = (text) => tools.hint(text);
  stage.lost = (lost) => {
    blind.hidden = !lost;
  };
  stage.background = options.background ?? "";
  if (options.top) stage.top = true;
  if (options.view) stage.view = options.view;
  press();
  element.replaceChildren(create("div", "ros-bar", title, controls), stage.element, list.element);

  world.changed = () => {
    frames.look();
    list.look();
  };
  ros.keep(element, { view: "object", frame: "string", displays: "object" }, () => state(stage, frames, list),
    (state, odd) => {
      if (isView(state.view)) stage.view = state.view;
      else if (state.view) odd();
      if (state.frame) world.choose(state.frame.slice(0, 200));
      if (state.displays) list.restore(state.displays, odd);
      press();
    });
  const unlook = whileSeen(element, () => world.begin());
  return () => {
    unlook();
    tools.close();
    world.close();
    stage.close();
    element.replaceChildren();
  };
}

/** What the visitor has chosen. @param {Stage} stage @param {FrameChooser} frames @param {DisplayList} list @returns {Shared} */
function state(stage, frames, list) {
  return { view: stage.chosen ? stage.view : undefined, frame: frames.chosen, displays: list.changed() };
}

/** @param {any} view @returns {view is View} */
function isView(view) {
  const isPoint = (/** @type {any} */ point) => Array.isArray(point) && point.length === 3 && point.every(Number.isFinite);
  return Boolean(view) && isPoint(view.eye) && isPoint(view.target) && view.zoom > 0 && Number.isFinite(view.zoom)
    && typeof view.top === "boolean";
}
