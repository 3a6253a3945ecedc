// @ts-check
// The class of JupyterLite's kernels whose cells run in nodes.

import { Conversation } from "./conversation.js";

/** @import { NodeHandle } from "../protocol.js" */

/**
 * The nodes that run notebooks: `run` starts one, which is gone when it has ended.
 * @typedef {{run(): NodeHandle}} Kernels
 */

const ABOUT = {
  implementation: "sitegen",
  implementation_version: "1",
  language_info: {
    name: "python",
    version: "3.14",
    mimetype: "text/x-python",
    file_extension: ".py",
    codemirror_mode: { name: "python", version: 3 },
    nbconvert_exporter: "python",
    pygments_lexer: "ipython3",
  },
  protocol_version: "5.3",
  status: "ok",
  banner: "Python with rclpy, on the ROS graph of this page",
  help_links: [],
};

/**
 * Return the class of kernels.
 * @param {new (options: any) => any} BaseKernel that of JupyterLite @param {Kernels} kernels
 */
export function kernelClass(BaseKernel, kernels) {
  return class extends BaseKernel {
    #node = new Conversation(kernels.run(), /** @type {any} */ (this));

    get ready() {
      return this.#node.ready;
    }

    interrupt() {
      this.#node.interrupt();
    }

    dispose() {
      if (!this.isDisposed) this.#node.end();
      super.dispose();
    }

    kernelInfoRequest = async () => ABOUT;

    /** @param {{code: string}} content */
    async executeRequest({ code }) {
      const found = await this.#node.ask("run", { code });
      const { status, ename, evalue, traceback } = found;
      if (status === "error") this.publishExecuteError({ ename, evalue, traceback });
      return { ...found, execution_count: this.executionCount, user_expressions: {} };
    }

    /** @param {{code: string, cursor_pos: number}} content */
    completeRequest = ({ code, cursor_pos: at }) => this.#node.ask("complete", { code, at });

    /** @param {{code: string, cursor_pos: number, detail_level: number}} content */
    inspectRequest = ({ code, cursor_pos: at, detail_level: detail }) =>
      this.#node.ask("inspect", { code, at, detail });

    /** @param {{code: string}} content */
    isCompleteRequest = ({ code }) => this.#node.ask("is_complete", { code });

    /** @param {{value?: string}} content */
    inputReply = ({ value = "" }) => this.#node.reply(value);

    // There are no widgets of Jupyter, which would use these.
    commInfoRequest = async () => ({ status: "ok", comms: {} });
    commOpen = async () => {};
    commMsg = async () => {};
    commClose = async () => {};
  };
}
