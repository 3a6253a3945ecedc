// The choice among versions of the site. The list is read from beside them, so old versions know new ones.

/** @typedef {{ version: string, aliases: string[] }} Version */

const select = /** @type {HTMLSelectElement | null} */ (document.querySelector("select.versions"));
if (select) offer(select);

/** @param {HTMLSelectElement} select */
async function offer(select) {
  const versions = await listed(select.dataset.list ?? "");
  const current = select.value;
  if (versions.length < 2) return;
  select.replaceChildren(
    ...versions.map(({ version, aliases }) => {
      const names = aliases.length ? `${version} (${aliases.join(", ")})` : version;
      return new Option(names, version, version === current, version === current);
    }),
  );
  select.hidden = false;
  const leave = () => go(new URL(select.dataset.root ?? "", location.href), select.value);
  // The arrow keys change a closed list at every press; Enter says which version was meant.
  let browsing = false;
  select.addEventListener("pointerdown", () => (browsing = false));
  select.addEventListener("keydown", ({ key }) => {
    browsing = key !== "Enter" && key !== " ";
    if (key === "Enter" && select.value !== current) leave();
  });
  select.addEventListener("change", () => browsing || leave());
  // Who comes back finds the version of this page.
  addEventListener("pageshow", () => (select.value = current));
}

/**
 * Return the versions, or none where they cannot be had, as without a network.
 *
 * @param {string} address
 * @returns {Promise<Version[]>}
 */
async function listed(address) {
  try {
    const response = await fetch(address, { cache: "no-cache" });
    return response.ok ? await response.json() : [];
  } catch {
    return [];
  }
}

/**
 * Go to this page in another version, or to its home page if it has no such page.
 *
 * @param {URL} root folder of this version
 * @param {string} version
 */
async function go(root, version) {
  const home = new URL(`../${version}/`, root).href;
  const page = home + location.pathname.slice(root.pathname.length);
  const there = await fetch(page, { method: "HEAD" }).then(
    (response) => response.ok,
    () => false,
  );
  location.assign(there ? page + location.hash : home);
}
