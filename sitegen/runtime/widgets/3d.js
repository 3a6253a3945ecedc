// @ts-check
// The robot and its world in 3D: frames, models, sensors and markers, as RViz shows them.

import { watchColours } from "../ui/colours.js";
import { download } from "../ui/download.js";
import { create, setNote } from "../ui/elements.js";
import { fullScreenButton } from "../ui/fullScreen.js";
import { whileNear } from "../ui/looking.js";
import { tool, Toolbar } from "../ui/toolbar.js";
import { place } from "../place.js";
import { say } from "../ui/words.js";
import { Camera, Map as MapIcon, Scan } from "../vendor/icons.js";
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
 *   resources?: Record<string, string>, captions?: string[]}} options `displays` each have a `kind` and its options;
 *   without them, the view shows what there is. `resources` maps the URLs of meshes to addresses. What the nodes named
 *   in `captions` print shows over the view
 * @returns {() => void} unmount
 */
export function mount(element, ros, options) {
  const stage = createStage(say("3D view; arrow keys turn it, with Shift they move it, + and - zoom, 0 shows everything"));
  if (typeof stage === "string") {
    const note = create("p", "ros-empty");
    setNote(note, stage, true);
    element.replaceChildren(create("div", "ros-bar", create("span", "ros-title", say("3D view"))), note);
    return () => element.replaceChildren();
  }
  return show(element, ros, options, stage);
}

/**
 * @param {HTMLElement} element @param {Ros} ros @param {any} options @param {Stage} stage
 */
function show(element, ros, options, stage) {
  const world = new World(ros, stage, options);
  const frames = new FrameChooser(world);
  const list = new DisplayList(world);
  const tools = new Tools(ros, stage, world, options.tools);
  const { top, fit, save, press } = cameraTools(stage);
  const controls = new Toolbar([top, fit, ...tools.buttons, save], [fullScreenButton(element)]);
  const blind = create("p", "ros-scene-lost",
    say("The browser has stopped drawing this view: the graphics card was reset, or too many views are open."));
  blind.setAttribute("role", "alert");
  blind.hidden = true;
  stage.element.append(create("div", "ros-scene-tools", frames.element, controls.element), tools.note, blind);
  const shown = new AbortController();
  if (options.captions) {
    import(place("ui/caption.js")).then(({ showCaption }) => showCaption(stage.element, ros, options.captions, shown.signal));
  }
  stage.hint = (text) => tools.hint(text);
  stage.lost = (lost) => {
    blind.hidden = !lost;
  };
  stage.background = options.background ?? "";
  if (options.top) stage.top = true;
  if (options.view) stage.frame(options.view);
  press();
  element.replaceChildren(stage.element, list.element);
  world.recolour();
  const unwatch = watchColours(() => world.recolour());

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
  const unlook = whileNear(element, () => world.begin());
  return () => {
    unlook();
    unwatch();
    shown.abort();
    tools.close();
    world.close();
    stage.close();
    element.replaceChildren();
  };
}

/**
 * The buttons for what is in view; `press` shows whether it is seen from above.
 * @param {Stage} stage
 */
function cameraTools(stage) {
  const top = tool(say("Top"), MapIcon, () => {
    stage.top = !stage.top;
    stage.fit();
    press();
  }, say("Look straight down"));
  const press = () => top.setAttribute("aria-pressed", String(stage.top));
  const fit = tool(say("Fit"), Scan, () => {
    stage.chosen = false;
    stage.fit();
  }, say("Show everything"));
  const save = tool(say("Picture"), Camera, async () => {
    const blob = await stage.picture();
    if (blob) download(blob, "3d.png");
  }, say("Save a picture"));
  return { top, fit, save, press };
}

/** What the visitor has chosen. @param {Stage} stage @param {FrameChooser} frames @param {DisplayList} list @returns {Shared} */
function state(stage, frames, list) {
  return { view: stage.chosen && !stage.framed ? stage.view : undefined, frame: frames.chosen, displays: list.changed() };
}

/** @param {any} view @returns {view is View} */
function isView(view) {
  const isPoint = (/** @type {any} */ point) => Array.isArray(point) && point.length === 3 && point.every(Number.isFinite);
  return Boolean(view) && isPoint(view.eye) && isPoint(view.target) && view.zoom > 0 && Number.isFinite(view.zoom)
    && typeof view.top === "boolean";
}
