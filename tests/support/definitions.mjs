// Print definitions as JSON, read from the JSON of the first argument: `bags` are types, written as the schema of a bag
// and read again; `shown` is what `ros2 interface show` says.

import { definitionText, readDefinitions } from "../../sitegen/runtime/bag/definition.js";
import { INTERFACE } from "../../sitegen/runtime/terminal/ros2/interface.js";

const types = JSON.parse(process.argv[2] ?? "{}");
const [root] = Object.keys(types);
const text = definitionText(types, root);
const verb = INTERFACE.verbs.find(({ name }) => name === "show");
let shown = "";
const out = async (said) => {
  shown += said;
};
// Without files of interfaces, as for types that only nodes of the page know.
const shell = { interfaces: { text: async () => undefined } };
await verb.run({ ros: { types }, out, shell }, { type: root });
console.log(JSON.stringify({ text, read: readDefinitions(root, text), shown }));
