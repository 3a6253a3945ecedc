// The dialog to share a page: a link that carries what runs and what panels show, and a frame of it for
// another page.

// How high a frame is at least and at most, in pixels: it can be scrolled.
const [LEAST, MOST] = [320, 720];
const LOCAL = /^(localhost|127\.\d+\.\d+\.\d+|\[::1\])$/;

/** @param {HTMLDialogElement} dialog */
export async function openShare(dialog) {
  if (dialog.open) return;
  const script = /** @type {HTMLScriptElement} */ (document.querySelector('script[src$="rosMain.js"]'));
  const { ros } = await import(script.src);
  const [link, embed] = /** @type {HTMLInputElement[]} */ ([...dialog.querySelectorAll("input, textarea")]);
  if (!link || !embed) return;
  const page = location.origin + location.pathname;
  const fragment = ros.link();
  link.value = `${page}${fragment}`;
  embed.value = frame(`${page}?embed${fragment}`);
  const said = /** @type {HTMLElement} */ (dialog.querySelector("[role=status]"));
  const { copied = "", byHand = "", local = "" } = dialog.dataset;
  said.textContent = LOCAL.test(location.hostname) ? local : "";
  for (const field of [link, embed]) {
    const button = /** @type {HTMLButtonElement} */ (field.nextElementSibling);
    button.onclick = async () => {
      try {
        await navigator.clipboard.writeText(field.value);
        said.textContent = copied;
      } catch {
        // Not allowed here, or no secure page: it is marked, so that the keyboard copies it.
        field.focus();
        field.select();
        said.textContent = byHand;
      }
    };
  }
  dialog.showModal();
  link.focus();
  // Backwards, so that its beginning is seen.
  link.setSelectionRange(0, link.value.length, "backward");
}

/** The HTML of a frame. @param {string} address */
function frame(address) {
  const height = document.querySelector("main")?.scrollHeight ?? LEAST;
  const robot = document.querySelector('[data-ros-widget="robot"]');
  const attributes = {
    src: address,
    title: document.title,
    width: "100%",
    height: Math.round(Math.min(Math.max(height, LEAST), MOST)),
    loading: "lazy",
    allow: robot ? "clipboard-write; bluetooth" : "clipboard-write",
    style: "border: 0",
  };
  const written = Object.entries(attributes).map(([name, value]) => `${name}="${escaped(String(value))}"`);
  return `<iframe ${written.join(" ")}></iframe>`;
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");
}
