// @ts-check
// Where a compiled program was: the stack of an error in the browser's words, in those of its author.

/**
 * The lines of a program. `at` has three numbers for each stretch of it: where it begins, counted from the
 * one before (bytes), a file by its number, or -1 where it is not the author's, and a line.
 * @typedef {{files: string[], at: number[]}} Lines
 * @typedef {{name: string, at: number}} Frame with the place in the program (bytes), -1 where that is not told
 */

// Chromium, Firefox, WebKit: the last has no places.
const FORMS = [
  /^ *at (?<name>.*) \(\S+:wasm-function\[\d+\]:0x(?<at>[0-9a-f]+)\)$/,
  /^(?<name>.*)@\S+:wasm-function\[\d+\]:0x(?<at>[0-9a-f]+)$/,
  /^.*wasm-function\[(?<name>.*)\]@\[wasm code\]$/,
];
// What the compiler and the library put between functions of the author and those that they call.
const MACHINERY = /^(std::|_|ros_|abort|exit)|::__invoke\(/;
const GLUE = /^(dynCall|invoke|legalstub)/;
const MAIN = /^(__original_main|__main_argc_argv|main\(.*\))$/;
// A lambda by the function that it is in, which is a lambda itself or nothing if that has no name.
const LAMBDA = /^(?:(?<inside>.*)::)?(?:\$_\d+|'lambda\d*'\(.*\)(?: const)?)::operator\(\)\(.*\)(?: const)?$/;
const STRING = /std::basic_string<char, std::char_traits<char>, std::allocator<char> ?>/g;

/**
 * Return the frames of the author's files, innermost first, each a line of text; between them what they
 * call of a library, by name.
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

/** @param {string} stack @returns {Frame[]} those in WebAssembly */
function frames(stack) {
  return stack.split("\n").flatMap((line) => {
    const groups = FORMS.map((form) => form.exec(line)?.groups).find((found) => found);
    if (!groups || GLUE.test(groups.name ?? "")) return [];
    const { name = "", at = "" } = groups;
    return [{ name: name.replaceAll("std::__2::", "std::"), at: at ? parseInt(at, 16) : -1 }];
  });
}

/** A function's name as its author knows it. @param {string} name @returns {string} */
function plain(name) {
  if (MAIN.test(name)) return "main";
  const lambda = LAMBDA.exec(name);
  if (lambda) return lambda.groups?.inside ? `lambda in ${plain(lambda.groups.inside)}` : "lambda";
  return name.replaceAll("(anonymous namespace)::", "").replace(STRING, "std::string").replace(/^void /, "");
}

/** The file and line of a place in the program. @param {number} place @param {Lines} lines */
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
