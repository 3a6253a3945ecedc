// Bundle the runtime into sitegen/bundles/, and write there which module imports which (modules.json). Run by
// hatch_build.py, and by sitegen itself in a checkout whose modules have changed (sitegen/site/bundles.py).
//
// One file starts a page, one runs in each kind of worker, and each other part of the page has its own; shared.js
// has the modules of several parts. A bundle has the path of the module that it is made from.

import { build } from "esbuild";
import { readFile, readdir, rm, writeFile } from "node:fs/promises";
import { dirname, join, posix, relative } from "node:path";

const RUNTIME = join(import.meta.dirname, "sitegen/runtime");
const TARGET = join(import.meta.dirname, "sitegen/bundles");

// rosMain.js has a copy of what it shares with the parts: a page of consoles loads no other file.
const START = ["rosMain.js"];
const IN_START = ["widgets/buttons.js", "widgets/console.js"];
// These have copies, too: what they share with single panels, such as a reader of YAML or the transforms of the 3D view,
// would come to every page with a panel.
const APART = ["widgets/dock.js", "widgets/launch.js", "widgets/terminal.js", "widgets/tf.js"];
const PARTS = ["page/pageClient.js", ...(await modulesIn("widgets", "widgets/robots"))].filter(
  (name) => ![...IN_START, ...APART].includes(name));
// What few parts share, and is too large for the file that all of them load.
const LARGE = ["ui/codeView.js", "ui/javascriptSyntax.js", "widgets/cell/view.js"];
// What others import of CodeMirror, too, is in the first of these: it may exist only once.
const CODEMIRROR = { "vendor/codemirror.js": "ui/codeView.js" };
const ALONE = [
  ...APART,
  ...LARGE,
  "bag/zstd.js",
  "client/client.js",
  "jupyter/extension.js",
  "jupyter/ownGraph.js",
  "jupyter/panel.js",
  "messages/filter/contentFilter.js",
  "messages/parameters/fileReader.js",
  "page/isolation.js",
  "page/notice.js",
  "page/searchIndex.js",
  "rosbridge/encoding.js",
  "rosbridge/outside.js",
  "rosbridge/robot/bridge.js",
  "rosbridge/rosbridge.js",
  "ui/caption.js",
  "ui/escapes.js",
  "ui/keyboard.js",
  "ui/lineTools.js",
  "widgets/buttons/options.js",
  "widgets/cell/panel.js",
  "widgets/image/decode.js",
  "widgets/robots/parts/moveHub.js",
  "workers/bag/bagNode.js",
  "workers/cpp/cppNode.js",
  "workers/cpp/packageFiles.js",
  "workers/cpp/stackTrace.js",
  "workers/environment.js",
  "workers/gateway/gatewayNode.js",
  "workers/javascript/javascriptNode.js",
  "workers/launch/launchReader.js",
  "workers/python/pythonNode.js",
  "workers/python/pythonSync.js",
  "workers/ros2wasm/ros2wasmNode.js",
  ...(await modulesIn("ui/words")),
];

const OPTIONS = /** @type {import("esbuild").BuildOptions} */ ({
  absWorkingDir: RUNTIME,
  bundle: true,
  format: "esm",
  minify: true,
  target: "es2022",
  sourcemap: "external",
  legalComments: "none",
  logLevel: "silent",
  metafile: true,
  outdir: TARGET,
  outbase: RUNTIME,
});

const metafiles = await bundled().catch((error) => {
  // Several bundles may have the module that is wrong.
  const found = error.errors?.map(({ location, text }) => `${location?.file}:${location?.line}: ${text}`);
  console.error(found ? [...new Set(found)].join("\n") : error);
  process.exit(1);
});
const modules = Object.assign({}, ...metafiles.map(({ inputs }) => Object.fromEntries(
  Object.entries(inputs)
    .filter(([name]) => !name.startsWith("part:"))
    .map(([name, { imports }]) => [name, imports.map((one) => nameOf(one, name))]))));
const bundles = Object.fromEntries(metafiles.flatMap(({ outputs }) => Object.entries(outputs))
  .filter(([name]) => name.endsWith(".js"))
  .map(([name, { imports, inputs }]) => [named(name), {
    imports: imports.map((one) => (one.external ? nameOf(one, named(name)) : named(one.path))),
    modules: Object.keys(inputs).filter((input) => !input.startsWith("part:")),
  }]));
await writeFile(join(TARGET, "modules.json"), `${JSON.stringify({ bundles, modules }, null, 1)}\n`);
await writeFile(join(TARGET, "displays.json"), `${JSON.stringify(await displays(), null, 1)}\n`);
await removeOthers(Object.keys(bundles).flatMap((name) => [name, `${name}.map`]));

/** What site.yaml can say of each display of a 3D view: its modules are the only ones that know. */
async function displays() {
  const { KINDS } = await import(join(RUNTIME, "widgets/3d/kinds.js"));
  return Object.fromEntries(Object.entries(KINDS).map(([name, { title, types, defaults, choices = {} }]) =>
    [name, { title, types, defaults, choices }]));
}

/** Write the bundles, and return what esbuild says about them. */
async function bundled() {
  const alone = await Promise.all([...START, ...ALONE].map((entry) => build({
    ...OPTIONS, entryPoints: [entry], plugins: [...(LARGE.includes(entry) ? [apart(entry)] : []), keepPlaces(entry)],
  })));
  const parts = await build({
    ...OPTIONS,
    entryPoints: PARTS.map((entry) => ({ in: `part:${entry}`, out: entry.replace(/\.js$/, "") })),
    plugins: [apart(), importing(await sharedModules())],
    splitting: true,
    chunkNames: "shared",
  });
  return [...alone, parts].map(({ metafile }) => metafile);
}

/** Let a module import those of LARGE as they are. @param {string} [entry] itself @returns {import("esbuild").Plugin} */
function apart(entry) {
  return {
    name: "apart",
    setup({ onResolve }) {
      onResolve({ filter: /\.js$/ }, ({ path, resolveDir }) => {
        const name = relative(RUNTIME, join(resolveDir, path));
        const within = CODEMIRROR[name];
        if (entry && within && within !== entry) return { path: `./${posix.relative(dirname(entry), within)}`, external: true };
        return LARGE.includes(name) && name !== entry ? { path, external: true } : undefined;
      });
    },
  };
}

/** The modules in some folders of the runtime. @param {string[]} folders */
async function modulesIn(...folders) {
  const found = await Promise.all(folders.map(async (folder) =>
    (await readdir(join(RUNTIME, folder))).map((name) => `${folder}/${name}`)));
  return found.flat().filter((name) => name.endsWith(".js")).sort();
}

/** The modules of more than one part. */
async function sharedModules() {
  const found = await Promise.all(PARTS.map(async (entry) =>
    Object.keys((await build({ ...OPTIONS, entryPoints: [entry], plugins: [apart()], write: false })).metafile.inputs)));
  const all = found.flat();
  return [...new Set(all.filter((name, index) => all.indexOf(name) !== index))].sort();
}

/**
 * Let every part import the same modules: esbuild then puts these into one file.
 * @param {string[]} shared @returns {import("esbuild").Plugin}
 */
function importing(shared) {
  return {
    name: "importing",
    setup({ onLoad, onResolve }) {
      onResolve({ filter: /^part:/ }, ({ path }) => ({ path: path.slice("part:".length), namespace: "part" }));
      onLoad({ filter: /.*/, namespace: "part" }, ({ path }) => ({
        contents: [...shared.map((name) => `import "./${name}";`), `export * from "./${path}";`].join("\n"),
        resolveDir: RUNTIME,
      }));
    },
  };
}

/**
 * Let import.meta.url be the address of the module, as without a bundle.
 * @param {string} entry @returns {import("esbuild").Plugin}
 */
function keepPlaces(entry) {
  return {
    name: "keep places",
    setup({ onLoad }) {
      onLoad({ filter: /\.js$/ }, async ({ path }) => {
        const from = posix.relative(dirname(entry), relative(RUNTIME, path));
        const own = `new URL(${JSON.stringify(from)}, import.meta.url).href`;
        return { contents: (await readFile(path, "utf8")).replaceAll("import.meta.url", own) };
      });
    },
  };
}

/**
 * What `from` imports; external modules are named as in its source.
 * @param {{path: string, external?: boolean}} one @param {string} from
 */
function nameOf({ path, external }, from) {
  return external ? posix.join(dirname(from), path) : path;
}

/** The name of an output, by its path from the runtime. @param {string} path */
function named(path) {
  return relative(TARGET, join(RUNTIME, path));
}

/** Remove the bundles of modules that are gone. @param {string[]} kept */
async function removeOthers(kept) {
  for (const entry of await readdir(TARGET, { recursive: true, withFileTypes: true })) {
    const file = join(entry.parentPath, entry.name);
    const gone = /\.js(\.map)?$/.test(entry.name) && !kept.includes(relative(TARGET, file));
    if (gone) await rm(file);
  }
}
