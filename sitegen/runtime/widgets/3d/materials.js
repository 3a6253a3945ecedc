// @ts-check
// The materials of a robot's description, by the rules of urdfdom.

import { say } from "../../ui/words.js";

/**
 * Let the whole description use each material by its name: those of the robot first, then the first that a link
 * defines. Return what is wrong with materials.
 * @param {Element} robot changed: the materials of links become materials of the robot
 * @returns {string[]}
 */
export function shareMaterials(robot) {
  /** @type {Set<string>} */
  const known = new Set();
  const faults = [];
  for (const material of childrenOf(robot, "material")) {
    const name = material.getAttribute("name") ?? "";
    if (known.has(name)) {
      faults.push(say("material '{}' is defined twice", name));
      material.remove();
    }
    known.add(name);
  }
  for (const link of childrenOf(robot, "link")) {
    for (const visual of childrenOf(link, "visual")) {
      const [material] = childrenOf(visual, "material");
      const name = material?.getAttribute("name");
      if (!material || !name || known.has(name)) continue;
      if (isDefined(material)) {
        known.add(name);
        robot.append(material.cloneNode(true));
      } else {
        faults.push(say("material '{}' of link '{}' is not defined", name, link.getAttribute("name")));
      }
    }
  }
  return faults;
}

/** @param {Element} element @param {string} name */
function childrenOf(element, name) {
  return [...element.children].filter(({ nodeName }) => nodeName === name);
}

/** Whether a material is more than a name. @param {Element} material */
function isDefined(material) {
  return childrenOf(material, "color").some((color) => color.hasAttribute("rgba"))
    || childrenOf(material, "texture").some((texture) => texture.hasAttribute("filename"));
}
