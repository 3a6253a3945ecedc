// @ts-check
// Translate the stack of a browser's error into functions, files and lines of a compiled program.

/**
 * The line table of a program. `at` has three numbers for each range: the distance of its beginning from that of the
 * range before (bytes), the index of a file, -1 for files of others, and the line.
 * @typedef {{files: string[], at: number[]}} Lines
 * @typedef {{name: string, at: number}} Frame with the position in the program (bytes), -1 if unknown
 */

// Chromium, Firefox and WebKit, which has no positions.
const FORMS = [
  /^ *at (?<name>.*) \(\S+:wasm-function\[\d+\]:0x(?<at>[0-9a-f]+)\)$/,
  /^(?<name>.*)@\S+:wasm-function\[\d+\]:0x(?<at>[0-9a-f]+)$/,
  /^.*wasm-function\[(?<name>.*)\]@\[wasm code\]$/,
];
// Functions of the compiler and the library between those of the author and those that they call.
const MACHINERY = /^(std::|_|ros_|abort|exit)|::__invoke\(/;
const GLUE = /^(dynCall|invoke|legalstub)/;
const MAIN = /^(__original_main|__main_argc_argv|main\(.*\))$/;
// A lambda and the function around it, which may be a lambda itself, or missing if it has no name.
const LAMBDA = /^(?:(?<inside>.*)::)?(?:\$_\d+|'lambda\d*'\(.*\)(?: const)?)::operator\(\)\(.*\)(?: const)?$/;
const STRING = /std::basic_string<char, std::char_traits<char>, std::allocator<char> ?>/g;

/**
 * Return the frames in the author's files, innermost first, as lines of text, with the names of the library functions
 * that they call.
 * @param {string} stack of an error @param {Lines} lines
 */
export function traceOf(stack, lines) {
  /** @type {{text: string, times: number}[]} */
  const told = [];
  /** @param {string} text */
  const tell = (text) => {
    const last = told.at(-1);
    if (last?.text === text) last.times += 1;
    else told.push({ text, times: 1 });
  };
  let called = "";
  for (const { name, at } of frames(stack)) {
    const place = placeOf(at, lines);
    if (place && MACHINERY.test(name)) continue;
    if (place) {
      if (called && !MACHINERY.test(called)) tell(plain(called));
      tell(`${plain(name)} (${place})`);
    }
    called = place ? "" : name;
  }
  const often = (/** @type {number} */ times) => (times > 1 ? `, ${times} times` : "");
  return told.map(({ text, times }) => `    at ${text}${often(times)}`).join("\n");
}

/** @param {string} stack @returns {Frame[]} frames in WebAssembly */
function frames(stack) {
  return stack.split("\n").flatMap((line) => {
    const groups = FORMS.map((form) => form.exec(line)?.groups).find((found) => found);
    if (!groups || GLUE.test(groups.name ?? "")) return [];
    const { name = "", at = "" } = groups;
    return [{ name: name.replaceAll("std::__2::", "std::"), at: at ? parseInt(at, 16) : -1 }];
  });
}

/** Return the name of a function as in the source. @param {string} name @returns {string} */
function plain(name) {
  if (MAIN.test(name)) return "main";
  const lambda = LAMBDA.exec(name);
  if (lambda) return lambda.groups?.inside ? `lambda in ${plain(lambda.groups.inside)}` : "lambda";
  return name.replaceAll("(anonymous namespace)::", "").replace(STRING, "std::string").replace(/^void /, "");
}

/** Return the file and line of a position in the program, or "". @param {number} place @param {Lines} lines */
function placeOf(place, { files, at }) {
  let begin = 0;
  let found = "";
  for (let i = 0; i + 2 < at.length; i += 3) {
    begin += at[i] ?? 0;
    if (begin > place) break;
    const file = files[at[i + 1] ?? -1];
    found = file ? `${file}:${at[i + 2]}` : "";
  }
  return found;
}
