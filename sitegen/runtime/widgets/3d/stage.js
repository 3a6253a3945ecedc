// @ts-check
// The drawing itself: a WebGL canvas, cameras that visitors move, and light. It draws a frame only when asked.

import {
  Box3, Color, Group, MOUSE, OrbitControls, OrthographicCamera, PerspectiveCamera,
  Raycaster, Scene, TOUCH, Vector2, Vector3, WebGLRenderer,
} from "../../vendor/three.js";
import { create } from "../../ui/elements.js";
import { say } from "../../ui/words.js";
import { isLight } from "./color.js";
import { Light } from "./light.js";

/** @typedef {{top: boolean, eye: number[], target: number[], zoom: number}} View where the camera is and looks (m) */

// The field of view of RViz's orbit camera, in degrees.
const ANGLE = 45;
// Most content does not fill the sphere around it, so a part of that may be out of view.
const FILLED = 0.8;
// Seen from above, content fills this part of the width or the height.
const MARGIN = 0.9;
// Smaller content is not magnified (m).
const SMALL = 0.2;
const START = new Vector3(-4, -4, 4);
// Width by height of what RViz shows, in the window that it opens.
const USUAL = 4 / 3;
// Radians, parts of the distance, and zoom for each press of a key.
const TURN = Math.PI / 24;
const SHIFT = 0.08;
const ZOOM = 1.2;
const BLACK = 0x000000;
const WHITE = 0xffffff;
/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class Stage {
  scene = new Scene();
  /** What `fit` shows. */
  content = new Group();
  element = create("div", "ros-scene");
  canvas = create("canvas", "");
  /** Called before each frame, with the time (ms). @type {(now: number) => void} */
  prepare = () => {};
  /** Called when the visitor has moved the camera. */
  moved = () => {};
  /** Called with how the view is moved, after a gesture that scrolls the page. @type {(text: string) => void} */
  hint = () => {};
  /** Called when the browser can draw no longer, or again. @type {(lost: boolean) => void} */
  lost = () => {};
  /** The colour of what has none of its own: dark on a light background, and white on a dark one. */
  ink = new Color(WHITE);
  /** Whether the visitor or an option decides what is in view. */
  chosen = false;
  /** What the author has framed, until the visitor moves the camera. @type {View | undefined} */
  #framed;
  #renderer;
  #light;
  #perspective = new PerspectiveCamera(ANGLE, 1, 0.01, 1000);
  #top = new OrthographicCamera(-1, 1, 1, -1, -1000, 1000);
  #orbit;
  #pan;
  #isTop = false;
  #frame = 0;
  #size = new Vector2(1, 1);
  #resized = new ResizeObserver(() => this.#resize());
  #closed = false;
  #aiming = false;

  /** Throws an Error if the browser has no WebGL. @param {string} label of the drawing, for screen readers */
  constructor(label) {
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", label);
    const context = this.canvas.getContext("webgl2", { antialias: true, alpha: true });
    if (!context) throw new Error("no WebGL");
    this.#renderer = new WebGLRenderer({ canvas: this.canvas, context });
    this.#renderer.shadowMap.enabled = true;
    this.element.append(this.canvas);
    this.#perspective.up.set(0, 0, 1);
    this.#perspective.position.copy(START);
    this.#top.up.set(0, 1, 0);
    this.#top.position.set(0, 0, 10);
    this.#light = new Light(this.scene, [this.#perspective, this.#top]);
    this.scene.add(this.content, this.#perspective, this.#top);
    this.#orbit = this.#control(this.#perspective);
    this.#pan = this.#control(this.#top);
    this.#pan.enableRotate = false;
    this.#pan.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    this.#pan.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    this.#select();
    this.canvas.addEventListener("keydown", (event) => this.#press(event));
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.lost(true);
    });
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.lost(false);
      this.redraw();
    });
    for (const type of ["focus", "blur"]) this.canvas.addEventListener(type, () => this.#touch());
    this.#touch();
    // The browser took the finger for scrolling.
    this.canvas.addEventListener("pointercancel", () => {
      if (!this.#isSelected) this.hint(say("Tap the view, then move it with one finger"));
    });
    this.canvas.addEventListener("wheel", ({ ctrlKey }) => {
      if (!ctrlKey && !this.#isSelected) this.hint(say("Click the view to zoom with the wheel"));
    }, { passive: true });
    this.#resized.observe(this.element);
  }

  /** @param {InstanceType<typeof PerspectiveCamera> | InstanceType<typeof OrthographicCamera>} camera */
  #control(camera) {
    // The wheel scrolls the page unless the visitor has selected the drawing, as with other drawings.
    const wheel = (/** @type {WheelEvent} */ event) => {
      controls.enableZoom = event.ctrlKey || this.#isSelected;
    };
    this.canvas.addEventListener("wheel", wheel, { capture: true, passive: true });
    const controls = new OrbitControls(camera, this.canvas);
    controls.zoomToCursor = true;
    controls.addEventListener("change", () => this.redraw());
    controls.addEventListener("start", () => {
      this.chosen = true;
      this.#framed = undefined;
    });
    controls.addEventListener("end", () => this.moved());
    return controls;
  }

  get #isSelected() {
    return document.activeElement === this.canvas;
  }

  /** Let a finger scroll the page upwards and downwards until the visitor has selected the drawing. */
  #touch() {
    this.canvas.style.touchAction = this.#aiming || this.#isSelected ? "none" : "pan-y";
  }

  get camera() {
    return this.#isTop ? this.#top : this.#perspective;
  }

  get #controls() {
    return this.#isTop ? this.#pan : this.#orbit;
  }

  /** Whether the camera looks straight down. */
  get top() {
    return this.#isTop;
  }

  set top(on) {
    if (on === this.#isTop) return;
    this.#isTop = on;
    this.#select();
    this.redraw();
  }

  /** Let the visitor's pointer move the camera, or not while a tool uses it. @param {boolean} on */
  set movable(on) {
    this.#controls.enabled = on;
    this.#aiming = !on;
    this.#touch();
  }

  /** Where the camera is, for shared links. @returns {View} */
  get view() {
    const round = (/** @type {InstanceType<typeof Vector3>} */ { x, y, z }) => [x, y, z].map((one) => Number(one.toFixed(3)));
    const { camera } = this;
    return { top: this.#isTop, eye: round(camera.position), target: round(this.#controls.target), zoom: camera.zoom };
  }

  set view({ top, eye, target, zoom }) {
    this.chosen = true;
    this.#framed = undefined;
    this.top = top;
    const [x = 0, y = 0, z = 0] = eye;
    const [a = 0, b = 0, c = 0] = target;
    this.camera.position.set(x, y, z);
    this.#controls.target.set(a, b, c);
    this.camera.zoom = zoom;
    this.camera.updateProjectionMatrix();
    this.#controls.update();
    this.redraw();
  }

  /** Whether the view is still what the author has framed. */
  get framed() {
    return Boolean(this.#framed);
  }

  /** Show what the author has framed, also where the panel is narrower than a window of RViz. @param {View} view */
  frame(view) {
    this.view = view;
    this.#framed = view;
  }

  /** @param {string} color of the background, like "#303030"; the theme's if empty */
  set background(color) {
    this.scene.background = color ? new Color(color) : null;
    this.redraw();
  }

  /** Read the colours of the page, which may have become light or dark, and return whether the ink is another one. */
  recolour() {
    const former = this.ink.getHex();
    const { background } = this.scene;
    if (background instanceof Color) this.ink.setHex(isLight(background) ? BLACK : WHITE);
    else this.ink.setStyle(getComputedStyle(this.element).color);
    return this.ink.getHex() !== former;
  }

  /** Return a colour as it is drawn: white, with which RViz begins, is ink. @param {string} color like "#ff0000" */
  tint(color) {
    const given = new Color(color);
    return given.getHex() === WHITE ? this.ink.clone() : given;
  }

  /** Draw a frame soon. */
  redraw() {
    if (!this.#closed) this.#frame ||= requestAnimationFrame((now) => this.draw(now));
  }

  /** Draw a frame now. @param {number} now the time (ms) */
  draw(now = performance.now()) {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.prepare(now);
    const { camera } = this;
    const { target } = this.#controls;
    this.#light.follow(target, this.#isTop ? 2 / camera.zoom : camera.position.distanceTo(target));
    this.#renderer.render(this.scene, camera);
    if (this.#light.drew(this.#renderer.info.render.triangles)) this.redraw();
  }

  /** Stop drawing until the next `redraw`. */
  rest() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }

  /** Move the camera so that all content is in view. */
  fit() {
    this.#framed = undefined;
    const box = new Box3().setFromObject(this.content);
    if (box.isEmpty() || ![...box.min.toArray(), ...box.max.toArray()].every(Number.isFinite)) return;
    const middle = box.getCenter(new Vector3());
    const radius = Math.max(box.getSize(new Vector3()).length(), SMALL) / 2;
    const size = this.#renderer.getSize(new Vector2());
    const narrow = Math.min(1, size.x / size.y);
    if (this.#isTop) {
      this.#top.position.set(middle.x, middle.y, box.max.z + 10);
      this.#top.zoom = this.#topZoom(box.getSize(new Vector3()));
    } else {
      const towards = this.#perspective.position.clone().sub(this.#orbit.target).normalize();
      const away = (FILLED * radius) / Math.sin((ANGLE * Math.PI) / 360) / narrow;
      this.#perspective.position.copy(middle).addScaledVector(towards, away);
      this.#perspective.far = Math.max(1000, away * 100);
      this.#perspective.near = this.#perspective.far / 1e5;
    }
    this.#controls.target.copy(middle);
    this.camera.updateProjectionMatrix();
    this.#controls.update();
    this.redraw();
  }

  /** Return the zoom at which all of a box is in view from above. @param {InstanceType<typeof Vector3>} size of the box */
  #topZoom({ x, y }) {
    const { right, top } = this.#top;
    return MARGIN * Math.min((2 * right) / Math.max(x, SMALL), (2 * top) / Math.max(y, SMALL));
  }

  /**
   * Return the ray from the camera through a point of the canvas.
   * @param {{offsetX: number, offsetY: number}} point in CSS pixels
   */
  ray({ offsetX, offsetY }) {
    const { clientWidth, clientHeight } = this.canvas;
    const caster = new Raycaster();
    const pointer = new Vector2((offsetX / clientWidth) * 2 - 1, 1 - (offsetY / clientHeight) * 2);
    this.camera.updateMatrixWorld();
    caster.setFromCamera(pointer, this.camera);
    return caster;
  }

  /** Return a picture of what is shown, as PNG. @returns {Promise<Blob | null>} */
  picture() {
    this.draw();
    return new Promise((resolve) => this.canvas.toBlob(resolve));
  }

  /** The size in pixels, which wide lines need. */
  get size() {
    return this.#size;
  }

  close() {
    this.#closed = true;
    this.rest();
    this.#resized.disconnect();
    this.#orbit.dispose();
    this.#pan.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }

  #select() {
    this.#orbit.enabled = !this.#isTop;
    this.#pan.enabled = this.#isTop;
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!width || !height) return;
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.#renderer.setSize(width, height, false);
    this.#size.set(width, height);
    this.#perspective.aspect = width / height;
    this.#perspective.updateProjectionMatrix();
    // The shorter side shows two metres at zoom 1.
    const [x, y] = width > height ? [width / height, 1] : [1, height / width];
    Object.assign(this.#top, { left: -x, right: x, top: y, bottom: -y });
    this.#top.updateProjectionMatrix();
    if (!this.chosen) this.fit();
    else if (this.#framed) this.#widen(this.#framed);
    this.draw();
  }

  /** Go back until a view has the width that it has in RViz. @param {View} view */
  #widen(view) {
    if (this.#isTop) return;
    const { target } = this.#orbit;
    const factor = Math.max(1, USUAL / this.#perspective.aspect);
    this.#perspective.position.fromArray(view.eye).sub(target).multiplyScalar(factor).add(target);
    this.#orbit.update();
  }

  /** @param {KeyboardEvent} event */
  #press(event) {
    const { key, shiftKey, ctrlKey, altKey, metaKey } = event;
    if (ctrlKey || altKey || metaKey) return;
    const arrow = ARROWS[key];
    if (arrow) this.#step(arrow, shiftKey || this.#isTop);
    else if (key === "+" || key === "=") this.#zoom(ZOOM);
    else if (key === "-") this.#zoom(1 / ZOOM);
    else if (key === "0") this.fit();
    else return;
    event.preventDefault();
    this.chosen = true;
    this.#framed = undefined;
    this.moved();
  }

  /** Turn around the target, or move with it. @param {[number, number]} arrow @param {boolean} shift */
  #step([x, y], shift) {
    const { camera } = this;
    const { target } = this.#controls;
    const away = camera.position.clone().sub(target);
    if (shift) {
      const reach = (this.#isTop ? 2 / camera.zoom : away.length()) * SHIFT;
      const right = new Vector3().setFromMatrixColumn(camera.matrix, 0).multiplyScalar(x * reach);
      const up = new Vector3().setFromMatrixColumn(camera.matrix, 1).multiplyScalar(y * reach);
      target.add(right).add(up);
      camera.position.add(right).add(up);
    } else {
      away.applyAxisAngle(new Vector3(0, 0, 1), -x * TURN);
      const side = new Vector3(-away.y, away.x, 0).normalize();
      const lifted = away.clone().applyAxisAngle(side, -y * TURN);
      if (Math.hypot(lifted.x, lifted.y) > 0.02 * lifted.length() && lifted.dot(away) > 0) away.copy(lifted);
      camera.position.copy(target).add(away);
    }
    this.#controls.update();
    this.redraw();
  }

  /** @param {number} factor */
  #zoom(factor) {
    if (this.#isTop) {
      this.#top.zoom *= factor;
      this.#top.updateProjectionMatrix();
    } else {
      const { target } = this.#orbit;
      this.#perspective.position.sub(target).divideScalar(factor).add(target);
    }
    this.#controls.update();
    this.redraw();
  }
}

/** Return a Stage, or the reason why there is none. @param {string} label @returns {Stage | string} */
export function createStage(label) {
  try {
    return new Stage(label);
  } catch {
    return say("This browser cannot draw in 3D: WebGL is not available.");
  }
}
