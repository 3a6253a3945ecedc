// @ts-check
// Outputs of JupyterLab that are panels of the page around it.

/** @import { Lent } from "./panel.js" */

// As the module jupyros writes a panel.
export const MEDIA_TYPE = "application/vnd.sitegen.panel+json";

/**
 * Return what JupyterLab needs to show panels.
 * @param {new () => any} Widget that of Lumino @param {Lent | undefined} lent undefined without a page around
 */
export function panelFactory(Widget, lent) {
  class PanelOutput extends Widget {
    /** @param {{data: Record<string, any>}} model */
    async renderModel({ data }) {
      if (!lent) {
        const text = document.createElement("pre");
        text.textContent = `${data["text/plain"]}\nPanels need the page around JupyterLab; open this notebook there.`;
        this.node.replaceChildren(text);
        return;
      }
      const frame = document.createElement("iframe");
      frame.title = data["text/plain"];
      frame.style.cssText = "border: 0; inline-size: 100%; block-size: 4rem";
      // Copied into this document, as the cell that shows it may be run again.
      const described = typeof data[MEDIA_TYPE] === "string" ? JSON.parse(data[MEDIA_TYPE]) : data[MEDIA_TYPE];
      Object.assign(frame, { rosPanel: { described, lent } });
      frame.src = new URL("../../jupyter/panel.html", import.meta.url).href;
      this.node.replaceChildren(frame);
    }
  }
  return { safe: true, mimeTypes: [MEDIA_TYPE], createRenderer: () => new PanelOutput() };
}
