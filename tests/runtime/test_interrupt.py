"""No interrupt is lost between the two steps in which Pyodide checks for one."""

from __future__ import annotations

import json
import subprocess

from paths import ROOT

MODULE = ROOT / "sitegen/runtime/interrupt.js"
# Each check reads the number and then writes 0; the page interrupts between the two.
CHECKS = """
const { interrupt, interruptBuffer } = await import(process.argv[1]);
const byte = new Uint8Array(new SharedArrayBuffer(1));
const buffer = interruptBuffer(byte);
const numbers = [];
const check = (between = () => {}) => {
  numbers.push(buffer[0]);
  between();
  buffer[0] = 0;
};
check();
check(() => interrupt(byte));
check();
check();
console.log(JSON.stringify(numbers));
"""


def test_an_interrupt_during_a_check_is_seen_by_the_next_one() -> None:
    words = ["node", "--input-type=module", "-e", CHECKS, "--", str(MODULE)]
    done = subprocess.run(words, text=True, capture_output=True, check=True)
    assert json.loads(done.stdout) == [0, 0, 12, 0]
