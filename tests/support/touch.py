"""What fingers and eyes need of a page: targets that are large enough, text that can be read."""

from __future__ import annotations

from playwright.sync_api import Page

# In CSS pixels, as Apple and WCAG 2.5.5 ask for.
TARGET = 44
# What WCAG 1.4.3 asks for.
CONTRAST = 4.5

# A checkbox is pressed by its label, too. The whole screen of a terminal leads to its field.
SMALL = """(least) => {
  const all = document.querySelectorAll(`button, input, select, textarea, summary, .ros-bar a,
    .tools a, .tabbed-labels label`);
  const small = [...all].flatMap((element) => {
    const boxed = element.type === "checkbox";
    const target = boxed ? (element.closest("label, .ros-flag") ?? element) : element;
    const { width, height } = target.getBoundingClientRect();
    const seen = width > 0 && getComputedStyle(target).visibility === "visible";
    const covered = element.matches(".tabbed-set > input, .xterm-helper-textarea");
    if (!seen || covered || height > least - 0.1) return [];
    const text = target.textContent.trim() || element.getAttribute("aria-label") || "";
    return [`${element.localName}.${element.className} '${text}' is ${height} px high`];
  });
  return [...new Set(small)];
}"""

# Colours are drawn, because a style may give them in any notation.
PALE = """(least) => {
  const canvas = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  const light = (colours) => {
    canvas.clearRect(0, 0, 1, 1);
    for (const colour of colours) {
      canvas.fillStyle = colour;
      canvas.fillRect(0, 0, 1, 1);
    }
    const [r, g, b] = [...canvas.getImageData(0, 0, 1, 1).data].map((part) => {
      const value = part / 255;
      return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const hinted = [...document.querySelectorAll("[placeholder]:not([placeholder=''])")];
  return hinted.filter((input) => input.offsetWidth).flatMap((input) => {
    const behind = [];
    for (let one = input; one; one = one.parentElement) {
      behind.unshift(getComputedStyle(one).backgroundColor);
    }
    const { color, opacity } = getComputedStyle(input, "::placeholder");
    const shades = [light(behind), light([...behind, color])].sort((a, b) => a - b);
    const contrast = (shades[1] + 0.05) / (shades[0] + 0.05);
    const pale = contrast < least || opacity !== "1";
    return pale ? [`${input.placeholder}: contrast ${contrast}, opacity ${opacity}`] : [];
  });
}"""

ALIKE = """() => {
  const regions = [...document.querySelectorAll("section[aria-label], [role=region]")];
  const names = regions.map((element) => element.getAttribute("aria-label"));
  return names.filter((name, index) => names.indexOf(name) !== index);
}"""


def small_targets(page: Page) -> list[str]:
    """What can be pressed and is too low for a finger."""
    found: list[str] = page.evaluate(SMALL, TARGET)
    return found


def pale_placeholders(page: Page) -> list[str]:
    """Placeholders that have too little contrast."""
    found: list[str] = page.evaluate(PALE, CONTRAST)
    return found


def alike(page: Page) -> list[str]:
    """The names that several regions have in common."""
    found: list[str] = page.evaluate(ALIKE)
    return found
