// The button that shares the page: the dialog is loaded when somebody wants it.

import { loadSheet } from "./sheet.js";

const dialog = /** @type {HTMLDialogElement | null} */ (document.querySelector("dialog.share"));
const button = /** @type {HTMLElement | null} */ (document.querySelector(".share-button"));
/** @type {Promise<unknown> | undefined} */
let dressed;

if (dialog && button) {
  button.addEventListener("click", async () => {
    dressed ??= loadSheet("share.css");
    const [{ openShare }] = await Promise.all([import("./share.js"), dressed]);
    openShare(dialog);
  });
  button.hidden = false;
}
