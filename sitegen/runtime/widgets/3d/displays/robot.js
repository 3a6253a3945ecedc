// @ts-check
// The model of a robot, from its description: each link where its frame is.

import { Group, LoadingManager, Matrix4, URDFLoader } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { shareMaterials } from "../materials.js";
import { loadMesh, siteAddress } from "../meshes.js";
import { Axes, dispose } from "../shapes.js";
import { shade } from "../light.js";

/** @import { Context, Kind } from "../shown.js" */

/** @typedef {{name: string, group: any, parent: string, offset: any}} Link */

// A description may name so many links and not more.
const MOST_LINKS = 2000;

/** @type {Kind} */
export const kind = {
  title: say("Robot model"),
  types: ["std_msgs/msg/String"],
  defaults: { topic: "/robot_description", file: "", visual: true, collision: false, axes: false, alpha: 1, prefix: "" },

  create(context, options) {
    const model = new Model(context, options);
    if (options.file) model.load(options.file);
    return {
      receive: ({ data }) => {
        if (!options.file) model.show(data);
      },
      set: () => model.style(),
      update: () => model.update(),
      clear: () => model.clear(),
      close() {
        model.clear();
        dispose(context.root);
      },
    };
  },
};

class Model {
  #context;
  #options;
  #axes;
  /** @type {Link[]} */
  #links = [];
  /** Increases with each description: meshes of former ones may still come. */
  #version = 0;
  /** @type {Set<string>} */
  #faults = new Set();

  /** @param {Context} context @param {Record<string, any>} options */
  constructor(context, options) {
    this.#context = context;
    this.#options = options;
    this.#axes = new Axes(context.root);
  }

  /** Show the description in a file of the site. @param {string} file */
  async load(file) {
    try {
      const response = await fetch(this.#context.resource(file));
      if (!response.ok) throw new Error(say("the server answered {}", response.status));
      this.show(await response.text());
    } catch (error) {
      this.#context.say(say("{} could not be loaded: {}", file, error instanceof Error ? error.message : error));
    }
  }

  /** Throws an Error if the text is no description. @param {string} text */
  show(text) {
    this.clear();
    const version = this.#version;
    const { root, world, resource } = this.#context;
    const robot = parse(text);
    this.#faults = new Set([...shareMaterials(robot), ...placeTextures(robot, resource)]);
    this.#links = readLinks(robot, (url, material, done) => this.#mesh(url, material, done, version),
      () => world.redraw());
    for (const { group } of this.#links) root.add(group);
    this.style();
    place(world, this.#options.prefix, this.#links);
    world.appeared();
    world.redraw();
  }

  /** @param {string} url @param {any} material @param {(mesh: any) => void} done @param {number} version */
  async #mesh(url, material, done, version) {
    const { world, resource } = this.#context;
    try {
      const mesh = await loadMesh(url, resource);
      if (/\.(stl|obj)$/i.test(url)) paint(mesh, material);
      done(mesh);
    } catch (error) {
      done(new Group());
      if (version === this.#version) this.#faults.add(error instanceof Error ? error.message : String(error));
    }
    if (version !== this.#version) return;
    this.style();
    world.appeared();
    world.redraw();
  }

  style() {
    const { visual, collision, alpha } = this.#options;
    for (const { group } of this.#links) {
      for (const part of group.children) part.visible = part.isURDFCollider ? collision : visual;
      group.traverse((/** @type {any} */ { material }) => {
        for (const one of [material ?? []].flat()) {
          one.userData.alpha ??= one.opacity;
          one.opacity = one.userData.alpha * alpha;
          one.transparent = one.opacity < 1;
        }
      });
      shade(group);
    }
  }

  update() {
    const { world, say: tell } = this.#context;
    const without = place(world, this.#options.prefix, this.#links);
    // A robot alone is complete without frames.
    const missing = without.length && world.fixed ? [say("no transforms of {}", without.slice(0, 5).join(", "))] : [];
    if (this.#links.length) tell([...this.#faults, ...missing].join("; "));
    this.#axes.begin();
    for (const { group } of this.#options.axes ? this.#links : []) this.#axes.add(group.position, group.quaternion, 0.1, 0.01);
    this.#axes.end();
  }

  clear() {
    this.#version++;
    this.#faults.clear();
    for (const { group } of this.#links) {
      dispose(group);
      group.removeFromParent();
    }
    this.#links = [];
  }
}

/** Return the root of a description. Throws an Error if the text is no description. @param {string} text */
function parse(text) {
  const { documentElement } = new DOMParser().parseFromString(text, "application/xml");
  if (documentElement.nodeName !== "robot") throw new Error(say("not a robot description: its root is not <robot>"));
  if (documentElement.getElementsByTagName("link").length > MOST_LINKS) {
    throw new Error(say("the description has more than {} links", MOST_LINKS));
  }
  return documentElement;
}

/**
 * Give the textures of materials their addresses, and return the errors about those that the site does not have.
 * @param {Element} robot @param {(url: string) => string} resource
 */
function placeTextures(robot, resource) {
  const faults = [];
  for (const texture of [...robot.getElementsByTagName("texture")]) {
    const url = texture.getAttribute("filename");
    if (!url) continue;
    try {
      texture.setAttribute("filename", siteAddress(url, resource));
    } catch (error) {
      faults.push(error instanceof Error ? error.message : String(error));
      texture.remove();
    }
  }
  return faults;
}

/**
 * Return the links of a description, each with its shapes and with where it is in its parent if all joints are at 0.
 * @param {Element} root @param {(url: string, material: any, done: (mesh: any) => void) => void} load
 * @param {() => void} textured called when textures are loaded
 */
function readLinks(root, load, textured) {
  const loader = new URDFLoader(new LoadingManager(textured));
  loader.parseCollision = true;
  // Keeps "package://" in the paths: the site knows where these files are.
  loader.packages = (/** @type {string} */ name) => `package://${name}`;
  loader.loadMeshCb = (/** @type {string} */ url, /** @type {any} */ _manager, /** @type {any} */ material,
    /** @type {any} */ done) => load(url, material, done);
  const robot = loader.parse(/** @type {any} */ (root));
  repaint(robot);
  robot.updateMatrixWorld(true);
  return Object.entries(robot.links).map(([name, link]) => {
    const own = /** @type {any} */ (link);
    let above = own.parent;
    while (above && !above.isURDFLink) above = above.parent;
    const offset = above ? new Matrix4().copy(above.matrixWorld).invert().multiply(own.matrixWorld) : new Matrix4();
    const group = new Group();
    group.userData.link = true;
    for (const part of own.children.filter((/** @type {any} */ each) => each.isURDFVisual || each.isURDFCollider)) {
      group.add(part);
    }
    return { name, group, parent: above?.urdfName ?? "", offset };
  });
}

/** Colours of descriptions are those of screens, and the loader takes them for others. @param {any} robot */
function repaint(robot) {
  const materials = new Set();
  robot.traverse((/** @type {any} */ { material }) => material && materials.add(material));
  for (const material of materials) material.color.convertSRGBToLinear();
}

/** Give a mesh without colours the material of its link. @param {any} mesh @param {any} material */
function paint(mesh, material) {
  if (!material) return;
  mesh.traverse((/** @type {any} */ each) => {
    if (!each.isMesh || (each.material.name && each.material.map)) return;
    each.material = material;
  });
}

/**
 * Move the links to their frames, and return those that have none: these are where their parents carry them.
 * @param {import("../world.js").World} world @param {string} prefix
 * @param {Link[]} links
 */
function place({ transforms, fixed }, prefix, links) {
  const groups = new Map();
  const without = [];
  for (const { name, group, parent, offset } of links) {
    const { pose } = transforms.lookup(fixed, prefix ? `${prefix}/${name}` : name);
    if (pose) {
      group.position.set(...pose.position);
      group.quaternion.set(...pose.rotation);
    } else {
      without.push(name);
      const above = groups.get(parent);
      above?.updateMatrix();
      const matrix = above ? new Matrix4().multiplyMatrices(above.matrix, offset) : new Matrix4();
      matrix.decompose(group.position, group.quaternion, group.scale);
    }
    groups.set(name, group);
  }
  return without;
}

