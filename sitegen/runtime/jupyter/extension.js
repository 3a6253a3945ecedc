// @ts-check
// The extension of JupyterLab that runs notebooks in nodes of the page around it, or in a graph of their own.

import { kernelClass } from "./kernel.js";
import { panelFactory } from "./panels.js";

/** @import { Kernels } from "./kernel.js" */
/** @import { Lent } from "./panel.js" */
/** @typedef {{rosKernels?: Kernels, rosPanels?: Lent}} Around what the page lends to the frame */

// JupyterLab shows it where the kernel of a notebook is chosen. Notebooks made on a desktop name the same kernel.
const SPEC = { name: "python3", display_name: "Python (ROS 2)", language: "python", argv: [], resources: {} };

// JupyterLab shows the form of an output with the lowest rank; that of text is 100.
const RANK = 10;

/**
 * Return the plugins of the extension.
 * @param {any} scope the modules that JupyterLab shares, by name and version
 */
export async function extension(scope) {
  const { BaseKernel, IKernelClient, IKernelSpecs } = await shared(scope, "@jupyterlite/services");
  const { IRenderMimeRegistry } = await shared(scope, "@jupyterlab/rendermime");
  const { Widget } = await shared(scope, "@lumino/widgets");
  const page = /** @type {Around | null} */ (/** @type {unknown} */ (window.frameElement));
  const Kernel = kernelClass(BaseKernel, page?.rosKernels ?? (await ownKernels()));
  /** @type {Map<string, {interrupt(): void}>} */
  const running = new Map();
  return [{
    id: "sitegen-ros:kernel",
    autoStart: true,
    requires: [IKernelSpecs],
    optional: [IKernelClient],
    /** @param {any} _ @param {any} specs @param {any} client */
    activate(_, specs, client) {
      specs.register({
        spec: SPEC,
        create: async (/** @type {any} */ options) => {
          const kernel = new Kernel(options);
          running.set(options.id, kernel);
          return kernel;
        },
      });
      if (client) interruptAlso(client, running);
    },
  }, {
    id: "sitegen-ros:panels",
    autoStart: true,
    requires: [IRenderMimeRegistry],
    /** @param {any} _ @param {any} registry */
    activate(_, registry) {
      // Before the text, which every panel has, too.
      registry.addFactory(panelFactory(Widget, page?.rosPanels), RANK);
    },
  }];
}

/**
 * Let Interrupt reach the running cell: JupyterLite itself only takes back the cells that wait.
 * @param {any} client @param {Map<string, {interrupt(): void}>} running kernels by id
 */
function interruptAlso(client, running) {
  const interrupt = client.interrupt.bind(client);
  client.interrupt = async (/** @type {string} */ id) => {
    running.get(id)?.interrupt();
    await interrupt(id);
  };
}

/** Return the kernels of a graph of their own. @returns {Promise<Kernels>} */
async function ownKernels() {
  return (await import(new URL("ownGraph.js", import.meta.url).href)).kernels();
}

/** Return a module that JupyterLab shares. @param {any} scope @param {string} name */
async function shared(scope, name) {
  const [version] = Object.values(scope[name]);
  return (await version.get())();
}
