// @ts-check
// Load meshes: STL, COLLADA, OBJ and glTF files of the site.

import {
  ColladaLoader, Color, DoubleSide, GLTFLoader, Group, LoadingManager, Mesh, MeshLambertMaterial, MTLLoader, OBJLoader,
  STLLoader,
} from "../../vendor/three.js";
import { say } from "../../ui/words.js";

/** The meshes by their URL: several links may show the same. @type {Map<string, Promise<any>>} */
const loaded = new Map();

/**
 * Return a mesh with materials of its own. Reject with an Error that says what is wrong.
 * @param {string} url as in the description: `package://…` @param {(url: string) => string} resource its address
 * @returns {Promise<any>} a group, in metres and with z up as ROS has it
 */
export async function loadMesh(url, resource) {
  const address = siteAddress(url, resource);
  let loading = loaded.get(address);
  if (!loading) {
    loading = load(url, address);
    loaded.set(address, loading);
    loading.catch(() => loaded.delete(address));
  }
  return ownMaterials((await loading).clone());
}

/**
 * Give an object copies of its materials: others that show the same mesh have other colours and opacities. Its geometry
 * and textures may be disposed nevertheless, as the drawing loads what it needs again.
 * @param {any} object
 */
function ownMaterials(object) {
  const copies = new Map();
  const copied = (/** @type {any} */ material) => {
    if (!copies.has(material)) copies.set(material, material.clone());
    return copies.get(material);
  };
  object.traverse((/** @type {any} */ each) => {
    if (each.material) each.material = Array.isArray(each.material) ? each.material.map(copied) : copied(each.material);
  });
  return object;
}

/**
 * Return the address of what a description names. Throws an Error if the site does not have it.
 * @param {string} url @param {(url: string) => string} resource
 */
export function siteAddress(url, resource) {
  const address = resource(url);
  const known = address !== url || !/^(\/|(package|file|model):)/.test(url);
  if (!address || !known) throw new Error(say("the site does not contain {}", url));
  return address;
}

/** @param {string} url @param {string} address */
async function load(url, address) {
  const manager = new LoadingManager();
  const extension = /\.(\w+)$/.exec(url)?.[1]?.toLowerCase() ?? "";
  try {
    const read = READERS[extension];
    if (!read) throw new Error(say("not an STL, COLLADA, OBJ or glTF file"));
    return await read(address, manager);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    throw new Error(say("{} could not be loaded: {}", url, reason), { cause: error });
  }
}

/** @type {Record<string, (address: string, manager: any) => Promise<any>>} */
const READERS = {
  async stl(address, manager) {
    const geometry = await new STLLoader(manager).loadAsync(address);
    if (lacksNormals(geometry.getAttribute("normal"))) geometry.computeVertexNormals();
    return upright(new Mesh(geometry, new MeshLambertMaterial({ color: new Color(0xd0d3da) })));
  },
  async dae(address, manager) {
    const found = await new ColladaLoader(manager).loadAsync(address);
    if (!found) throw new Error(say("not a COLLADA file"));
    // Only the unit is applied: RViz ignores which axis is up, so authors have rotated what they needed.
    found.scene.quaternion.identity();
    return upright(found.scene);
  },
  async obj(address, manager) {
    const loader = new OBJLoader(manager);
    const text = await (await fetched(address)).text();
    const [, library] = /^mtllib\s+(.+?)\s*$/m.exec(text) ?? [];
    if (library) {
      const folder = address.slice(0, address.lastIndexOf("/") + 1);
      const materials = await new MTLLoader(manager).setPath(folder).loadAsync(library).catch(() => undefined);
      if (materials) loader.setMaterials(materials);
    }
    return upright(loader.parse(text));
  },
  gltf: readGltf,
  glb: readGltf,
};

/** @param {string} address @param {any} manager */
async function readGltf(address, manager) {
  const { scene } = await new GLTFLoader(manager).loadAsync(address);
  return upright(scene);
}

/** Whether a file left the normals of triangles at zero, as some exporters do. @param {any} normals */
function lacksNormals(normals) {
  for (let i = 0; i < normals.count; i++) {
    if (normals.getX(i) ** 2 + normals.getY(i) ** 2 + normals.getZ(i) ** 2 < 1e-3) return true;
  }
  return false;
}

/** @param {string} address */
async function fetched(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(say("the server answered {}", response.status));
  return response;
}

/** @param {any} object */
function upright(object) {
  const group = new Group();
  object.traverse((/** @type {any} */ each) => {
    // Lights and cameras of a file would light the whole scene.
    if (each.isLight || each.isCamera) each.visible = false;
    for (const material of [each.material ?? []].flat()) material.side = DoubleSide;
  });
  group.add(object);
  return group;
}
