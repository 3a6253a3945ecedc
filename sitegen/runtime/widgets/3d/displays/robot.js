// @ts-check
// The model of a robot, from its description: each link where its frame is.

import { Group, LoadingManager, Matrix4, URDFLoader } from "../../../vendor/three.js";
import { say } from "../../../ui/words.js";
import { loadMesh } from "../meshes.js";
import { Axes, dispose } from "../shapes.js";

/** @import { Kind } from "../shown.js" */

// A description may name so many links and not more.
const MOST_LINKS = 2000;

/** @type {Kind} */
export const kind = {
  title: say("Robot model"),
  types: ["std_msgs/msg/String"],
  defaults: { topic: "/robot_description", file: "", visual: true, collision: false, axes: false, alpha: 1, prefix: "" },

  create(context, options) {
    const { root, world, resource } = context;
    const axes = new Axes(root);
    /** @type {{name: string, group: any, parent: string, offset: any}[]} */
    let links = [];
    let version = 0;
    /** @type {Set<string>} */
    const faults = new Set();

    const clear = () => {
      version++;
      links = [];
      faults.clear();
      for (const child of [...root.children]) if (child.userData.link) child.removeFromParent();
    };
    const style = () => {
      for (const { group } of links) {
        for (const part of group.children) part.visible = part.isURDFCollider ? options.collision : options.visual;
        group.traverse((/** @type {any} */ { material }) => {
          for (const one of [material ?? []].flat()) {
            one.userData.alpha ??= one.opacity;
            one.opacity = one.userData.alpha * options.alpha;
            one.transparent = one.opacity < 1;
          }
        });
      }
    };
    const show = (/** @type {string} */ text) => {
      clear();
      const current = version;
      links = readLinks(text, async (url, material, done) => {
        try {
          const mesh = await loadMesh(url, resource);
          if (/\.(stl|obj)$/i.test(url)) paint(mesh, material);
          done(mesh);
          if (current !== version) return;
          style();
          world.appeared();
          context.redraw();
        } catch (error) {
          done(new Group());
          if (current !== version) return;
          faults.add(error instanceof Error ? error.message : String(error));
          context.say([...faults].join("; "));
        }
      });
      for (const { group } of links) root.add(group);
      style();
      place(world, options.prefix, links);
      world.appeared();
      context.redraw();
    };
    if (options.file) {
      fetch(resource(options.file)).then(async (response) => {
        if (!response.ok) throw new Error(say("the server answered {}", response.status));
        show(await response.text());
      }).catch((error) => context.say(say("{} could not be loaded: {}", options.file, error.message)));
    }
    return {
      receive: ({ data }) => {
        if (!options.file) show(data);
      },
      set: style,
      update() {
        const without = place(world, options.prefix, links);
        if (links.length && !faults.size) {
          context.say(without.length ? say("no transforms of {}", without.slice(0, 5).join(", ")) : "");
        }
        axes.begin();
        for (const { group } of options.axes ? links : []) axes.add(group.position, group.quaternion, 0.1, 0.01);
        axes.end();
      },
      clear,
      close() {
        clear();
        dispose(root);
      },
    };
  },
};

/**
 * Return the links of a description, each with its shapes and with where it is in its parent if all joints are at 0.
 * Throws an Error if the text is no description.
 * @param {string} text @param {(url: string, material: any, done: (mesh: any) => void) => void} load
 */
function readLinks(text, load) {
  const { documentElement } = new DOMParser().parseFromString(text, "application/xml");
  if (documentElement.nodeName !== "robot") throw new Error(say("not a robot description: its root is not <robot>"));
  if (documentElement.getElementsByTagName("link").length > MOST_LINKS) {
    throw new Error(say("the description has more than {} links", MOST_LINKS));
  }
  const loader = new URDFLoader(new LoadingManager());
  loader.parseCollision = true;
  // Keeps "package://" in the paths: the site knows where these files are.
  loader.packages = (/** @type {string} */ name) => `package://${name}`;
  loader.loadMeshCb = (/** @type {string} */ url, /** @type {any} */ _manager, /** @type {any} */ material,
    /** @type {any} */ done) => load(url, material, done);
  const robot = loader.parse(/** @type {any} */ (documentElement));
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
 * @param {{name: string, group: any, parent: string, offset: any}[]} links
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

