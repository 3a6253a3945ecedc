// Parse arguments as the terminal does, in Node: prints the verbs of ros2, or what each of some lines gives, as JSON.

import { readFileSync } from "node:fs";
import { argumentsOf, HelpAsked, parse, UsageError } from "../../sitegen/runtime/terminal/args/parse.js";
import { GROUPS, specOf } from "../../sitegen/runtime/terminal/ros2/ros2.js";
import { parse as parseLine, Unfinished } from "../../sitegen/runtime/terminal/shell/parse.js";

const [what, text] = process.argv.slice(2);
const given = () => JSON.parse(text ?? readFileSync(0, "utf8"));
const specs = GROUPS.flatMap((group) => (group.verbs ?? [undefined]).map((verb) => specOf(group, verb)));

if (what === "verbs") {
  console.log(JSON.stringify(specs.map((spec) => ({
    prog: spec.prog,
    about: spec.about,
    args: argumentsOf(spec).slice(1).map(({ type, complete, ...one }) => ({ ...one, type: type?.name })),
  })), (_, value) => (value === Infinity ? "inf" : value)));
} else if (what === "arguments") {
  console.log(JSON.stringify(given().map(([prog, words, columns]) => {
    try {
      return parse(specs.find((spec) => spec.prog === prog), words, columns, (extra) => `unrecognized ${extra.join(" ")}`);
    } catch (error) {
      if (!(error instanceof HelpAsked || error instanceof UsageError)) throw error;
      return error.message;
    }
  })));
} else {
  console.log(JSON.stringify(given().map((line) => {
    try {
      return parseLine(line);
    } catch (error) {
      return error instanceof Unfinished ? "unfinished" : error.message;
    }
  })));
}
