"""A site with panels that its author wrote, beside C++ nodes."""

from __future__ import annotations

import shutil
from pathlib import Path

from paths import ROOT

SITE = """\
site: {title: Mine}
nodes:
  talker: {package: cpp_chatter, executable: talker}
  server: {package: cpp_srvcli, executable: server}
pages:
  - path: /
    title: Mine
    content:
      - buttons: {node: talker, autostart: true}
      - buttons: {node: server, autostart: true}
      - panel: {file: panels/heard.js, title: Heard, options: {most: 3, words: [a, b]}}
      - panel: panels/sum.js
"""
HEARD = """\
import { shorten } from "./lib/shorten.js";
import "./heard.css";
import defaults from "./defaults.json" with { type: "json" };

/** @type {import("./ros").Mount<{most: number, words: string[]}>} */
export const mount = (element, ros, options) => {
  const list = document.createElement("ol");
  const wide = document.createElement("button");
  wide.textContent = defaults.label;
  wide.addEventListener("click", () => list.classList.toggle("wide"));
  ros.keep({ wide: "boolean" }, () => ({ wide: list.classList.contains("wide") }),
    ({ wide }) => list.classList.toggle("wide", wide));
  ros.subscribe("/chatter", "std_msgs/msg/String", ({ data }) => {
    const item = document.createElement("li");
    item.textContent = shorten(data);
    list.append(item);
    while (list.children.length > options.most) list.firstElementChild.remove();
  });
  const picture = document.createElement("img");
  picture.src = new URL("./dot.svg", import.meta.url).href;
  picture.alt = options.words.join(" ");
  element.append(list, wide, picture);
  return () => { document.body.dataset.ended = "heard"; };
};
"""
SUM = """\
export function mount(element, ros) {
  const add = document.createElement("button");
  add.textContent = "Add";
  const result = document.createElement("output");
  add.addEventListener("click", async () => {
    const { sum } = await ros.call("/add_two_ints", "tutorial_interfaces/srv/AddTwoInts",
      { a: 40n, b: 2n });
    result.textContent = String(sum);
  });
  const wrong = document.createElement("button");
  wrong.textContent = "Break";
  wrong.addEventListener("click", () => element.nothing.here());
  element.append(add, result, wrong);
}
"""
FILES = {
    "site.yaml": SITE,
    "panels/heard.js": HEARD,
    "panels/heard.css": ".wide li { color: rgb(1, 2, 3); }",
    "panels/defaults.json": '{"label": "Wide"}',
    "panels/lib/shorten.js": "export const shorten = (text) => text.replace('Hello, ', '');\n",
    "panels/dot.svg": '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9" width="9"'
    ' height="9"><circle cx="4" cy="4" r="4"/></svg>',
    "panels/sum.js": SUM,
}


def write_site(folder: Path) -> None:
    """Write the site, with the packages of a demo."""
    shutil.copytree(ROOT / "demos/demo05/src", folder / "src")
    for name, text in FILES.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
