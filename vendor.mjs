// Bundle the third-party libraries that widgets and scripts use into sitegen/runtime/vendor/, each as one module,
// with their licences. Run by hatch_build.py when package-lock.json has changed.

import { build } from "esbuild";
import { copyFile, mkdir, readdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join, posix, relative } from "node:path";

const TARGET = "sitegen/runtime/vendor";

/** What each bundle exports, by the bundle's name. */
const BUNDLES = {
  cdr: 'export { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";',
  cbor: `
    import "cbor2/types";
    export { decode } from "cbor2/decoder";
    export { encode } from "cbor2/encoder";`,
  png: 'export { encode } from "fast-png";',
  yaml: 'export { FAILSAFE_SCHEMA, load } from "js-yaml";',
  dagre: 'export { Graph, layout } from "@dagrejs/dagre";',
  codemirror: `
    export { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
    export { pythonLanguage } from "@codemirror/lang-python";
    export {
      bracketMatching, continuedIndent, delimitedIndent, flatIndent, foldInside, foldNodeProp, HighlightStyle,
      indentNodeProp, indentOnInput, indentUnit, LRLanguage, syntaxHighlighting,
    } from "@codemirror/language";
    export { EditorState, StateEffect, StateField } from "@codemirror/state";
    export { Decoration, drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
    export { styleTags, tags } from "@lezer/highlight";
    export { ContextTracker, ExternalTokenizer, LocalTokenGroup, LRParser } from "@lezer/lr";`,
  // What it needs of CodeMirror is in that bundle.
  javascript: 'export { javascriptLanguage } from "@codemirror/lang-javascript";',
  icons: `
    export {
      ArrowDown, ArrowUp, Camera, ChartScatter, Download, Ellipsis, Eraser, Flag, ListFilter, LocateFixed, Map, MapPin, Maximize2, Pause,
      Play, Plus, RotateCcw, RotateCw, Ruler, Scan, SlidersHorizontal, X, ZoomIn, ZoomOut,
    } from "lucide";`,
  inspect: 'export { formatWithOptions, inspect } from "node-inspect-extracted";',
  idiomorph: 'export { Idiomorph } from "idiomorph";',
  three: `
    export {
      AmbientLight, ArrowHelper, AxesHelper, Box3, BoxGeometry, BufferAttribute, BufferGeometry, CanvasTexture, Color,
      ConeGeometry, CylinderGeometry, DataTexture, DirectionalLight, DoubleSide, DynamicDrawUsage, Euler,
      Float32BufferAttribute, Group, HemisphereLight, InstancedBufferAttribute, InstancedMesh, Line, LineBasicMaterial, LineSegments,
      LoadingManager, Material, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, MOUSE, NearestFilter, Object3D,
      OrthographicCamera, PerspectiveCamera, Plane, PlaneGeometry, Points, PointsMaterial, Quaternion, Raycaster,
      RedFormat, RingGeometry, Scene, ShadowMaterial, SphereGeometry, Sprite, SpriteMaterial, SRGBColorSpace, TOUCH, Vector2, Vector3, WebGLRenderer,
    } from "three";
    export { OrbitControls } from "three/addons/controls/OrbitControls.js";
    export { LineMaterial } from "three/addons/lines/LineMaterial.js";
    export { LineSegments2 } from "three/addons/lines/LineSegments2.js";
    export { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
    export { ColladaLoader } from "three/addons/loaders/ColladaLoader.js";
    export { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
    export { MTLLoader } from "three/addons/loaders/MTLLoader.js";
    export { OBJLoader } from "three/addons/loaders/OBJLoader.js";
    export { STLLoader } from "three/addons/loaders/STLLoader.js";
    export { default as URDFLoader } from "urdf-loader";`,
  // For scripts of authors, as "sitegen/roslib": no module of the runtime imports it.
  roslib: 'export * from "roslib";',
  uplot: 'export { default as uPlot } from "uplot";',
  minisearch: 'export { default as MiniSearch } from "minisearch";',
  xterm: `
    export { FitAddon } from "@xterm/addon-fit";
    export { Terminal } from "@xterm/xterm";
    export { default as css } from "@xterm/xterm/css/xterm.css";`,
  mcap: `
    export { McapChunkBuilder, McapIndexedReader, McapRecordBuilder, McapStreamReader } from "@mcap/core";
    export { crc32, crc32Final, crc32Init, crc32Update } from "@foxglove/crc";
    export { decompress as unzstd } from "fzstd";`,
  // Programs in WebAssembly are part of their bundle: one file to load, also in a page that is a single file.
  lz4: `
    import create from "@foxglove/wasm-lz4/dist/wasm-lz4.js";
    import program from "@foxglove/wasm-lz4/dist/wasm-lz4.wasm";
    export { create, program };`,
  zstd: `
    import { compress, init } from "@bokuweb/zstd-wasm";
    import program from "./node_modules/@bokuweb/zstd-wasm/dist/web/zstd.wasm";
    export { compress, init, program };`,
};

/** The types of bundles whose packages have none, none of all of it, or none that can be checked. @type {Record<string, string>} */
const TYPES = {
  inspect: `
    export function formatWithOptions(options: object, ...values: unknown[]): string;
    export function inspect(value: unknown, options?: object): string;`,
  lz4: `
    export function create(options: object): Promise<any>;
    export const program: string;`,
  zstd: `
    export function compress(bytes: Uint8Array, level: number): Uint8Array;
    export function init(program: Uint8Array): Promise<void>;
    export const program: string;`,
};

/**
 * The declarations of roslib and of what it imports, for editors: `sitegen types` adds them to sitegen.d.ts. Each file
 * becomes a module with a name, because relative imports are not allowed inside a file that declares modules.
 */
async function roslibTypes() {
  const folder = "node_modules/roslib/dist/src";
  const files = (await readdir(folder, { recursive: true }))
    .filter((name) => name.endsWith(".d.ts") && !name.endsWith("WebSocketTransport.d.ts"))
    .map((name) => name.replaceAll("\\", "/"))
    .sort();
  const named = (/** @type {string} */ path) => `sitegen/roslib/${path.replace(/(\.d)?\.ts$/, "")}`;
  const declared = (/** @type {string} */ name, /** @type {string} */ text) =>
    `declare module "${name}" {\n${text.replace(/^(export )?declare /gm, "$1").trim()}\n}\n`;
  const modules = await Promise.all(files.map(async (file) => {
    const text = await readFile(join(folder, file), "utf8");
    return declared(named(file), text.replace(/(from ["'])([^"']+)/g, (_, from, path) =>
      from + named(path.startsWith(".") ? posix.join(dirname(file), path) : path)));
  }));
  const emitter = await readFile("node_modules/eventemitter3/index.d.ts", "utf8");
  return [
    declared("sitegen/roslib", 'export * from "sitegen/roslib/RosLib";'),
    ...modules,
    declared(named("eventemitter3"), emitter),
    // In a browser, these are the browser's own.
    declared(named("@xmldom/xmldom"), "export type Element = globalThis.Element;\nexport type Node = globalThis.Node;"),
  ].join("\n");
}

/** The policy of pages forbids the <style> elements of xterm, whose text then becomes a constructed style sheet. */
const WITHOUT_STYLES = {
  name: "without styles",
  setup({ onLoad }) {
    onLoad({ filter: /xterm\.m?js$/ }, async ({ path }) => {
      const text = await readFile(path, "utf8");
      const created = /[\w.]+\.createElement\("style"\)/g;
      if (path.endsWith("xterm.mjs") && !created.test(text)) throw new Error(`${path}: no styles; look what became of them`);
      const own = join(import.meta.dirname, "sitegen/runtime/ui/adoptedStyle.js");
      const first = `import { styleElement as ownStyle } from ${JSON.stringify(own)};\n`;
      return { contents: first + text.replaceAll(created, "ownStyle()") };
    });
  },
};

/** Languages find CodeMirror, which may exist only once, in its own bundle. */
const BESIDE_CODEMIRROR = {
  name: "beside codemirror",
  setup({ onResolve }) {
    const parts = /^@(codemirror\/(autocomplete|language|state|view)|lezer\/(common|highlight|lr))$/;
    onResolve({ filter: parts }, () => ({ path: "./codemirror.js", external: true, sideEffects: false }));
  },
};

/** Python comes as it is: its parts find each other by their names. bytecode.mjs adds its library. */
const PYTHON = ["pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm"];

TYPES.roslib = await roslibTypes();

const packages = new Set();
for (const [name, contents] of Object.entries(BUNDLES)) {
  const { metafile } = await build({
    stdin: { contents, resolveDir: import.meta.dirname },
    outfile: join(TARGET, `${name}.js`),
    bundle: true,
    format: "esm",
    minify: true,
    target: "es2022",
    loader: { ".css": "text", ".wasm": "base64" },
    external: ["fs", "path"], // imported in Node.js only
    // The address that zstd-wasm would load its program from; modules of a single file have none.
    ...(name === "zstd" && { define: { "import.meta.url": '"file:///"' } }),
    legalComments: "none", // all licences are in one file
    plugins: [WITHOUT_STYLES, ...(name === "javascript" ? [BESIDE_CODEMIRROR] : [])],
    metafile: true,
  });
  // For those who check the runtime.
  const declared = contents.replace(/export \{ default as (\w+) \} from "[^"]+\.css";/, "export const $1: string;");
  await writeFile(join(TARGET, `${name}.d.ts`), `${TYPES[name] ?? declared}\n`);
  for (const input of Object.keys(metafile.inputs)) {
    const folder = /^.*node_modules\/(@[^/]+\/)?[^/]+/.exec(input)?.[0];
    if (folder) packages.add(folder);
  }
}

await mkdir(join(TARGET, "pyodide"), { recursive: true });
for (const file of PYTHON) {
  await copyFile(join("node_modules/pyodide", file), join(TARGET, "pyodide", file));
}
// Of the list of packages that Python could load from elsewhere, only what it is for.
const lock = JSON.parse(await readFile("node_modules/pyodide/pyodide-lock.json", "utf8"));
const none = JSON.stringify({ info: lock.info, packages: {} });
await writeFile(join(TARGET, "pyodide/pyodide-lock.json"), none);
// The list itself is for the build, which takes from the distribution what nodes import.
const list = JSON.stringify({ packages: lock.packages });
await writeFile(join(TARGET, "pyodide-packages.json"), list);
const loader = join(TARGET, "pyodide/pyodide.mjs");
const text = await readFile(loader, "utf8");
await writeFile(loader, text.replace(/\/\/# sourceMappingURL=.*\n?/, ""));
await writeFile(
  join(TARGET, "pyodide/pyodide.d.mts"),
  "export function loadPyodide(options: object): Promise<any>;\n",
);

// A library may hold others already.
for (const folder of packages) {
  const { dependencies = {} } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  for (const name of Object.keys(dependencies)) packages.add(join("node_modules", name));
}
packages.add("node_modules/pyodide"); // what it depends on stays behind

const texts = [];
for (const folder of [...packages].sort()) {
  const about = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  const file = (await readdir(folder)).find((each) => /^licen[cs]e(\.\w+)?$/i.test(each));
  const text = file ? await readFile(join(folder, file), "utf8") : `Sources: ${about.homepage}`;
  texts.push(`${about.name} ${about.version} (${about.license})\n\n${text}`);
}
await writeFile(join(TARGET, "licenses.txt"), texts.join("\n\n----\n\n"));
console.log(`${relative(".", TARGET)}: ${Object.keys(BUNDLES).join(", ")}, pyodide`);
