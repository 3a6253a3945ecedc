"""Messages of compiled nodes, byte by byte against native ROS 2."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator

import pytest
from browser import serving
from native import Native, copy_test_msgs, differences
from paths import SITES
from playwright.sync_api import Browser

from sitegen.commands.build import build
from sitegen.report import Report

SITE = SITES / "cdr"
SEED = "20240607"

# A host for a program that reads its input and answers it, without a graph.
HOST = """
onmessage = async ({ data: [program, input] }) => {
  const bytes = new TextEncoder().encode(input);
  const output = [];
  let at = 0;
  const takeTyped = (heap, to, capacity) => {
    const part = bytes.subarray(at, at + capacity);
    heap.set(part, to);
    at += part.length;
    return part.length;
  };
  const end = (error) => postMessage([output, error]);
  try {
    const { default: load } = await import(`${program}.js`);
    const module = await load({
      ros: {
        argument: () => -1, fail: end, wait: async () => 0, wake() {}, now: () => Date.now(),
        reading() {}, typed: () => bytes.length - at, takeTyped,
      },
      locateFile: () => `${program}.wasm`,
      print: (line) => output.push(line),
      printErr: (line) => output.push(`stderr: ${line}`),
      onExit: (code) => end(code ? `exit code ${code}` : ""),
    });
    await WebAssembly.promising(module.rosFunction(module._ros_main_pointer()))();
  } catch (error) {
    end(String(error));
  }
};
"""
RUN = """([program, input]) => new Promise((resolve, reject) => {
  const worker = new Worker("host.js", { type: "module" });
  worker.onmessage = ({ data: [output, error] }) => {
    worker.terminate();
    error ? reject(new Error(`${error}: ${output.slice(-1)}`)) : resolve(output);
  };
  worker.onerror = ({ message }) => reject(new Error(message));
  worker.postMessage([program, input]);
})"""

Ask = Callable[[list[str]], list[str]]


@pytest.fixture(scope="module")
def native() -> Native:
    return Native()


@pytest.fixture(scope="module")
def ask(
    native: Native, browser: Browser, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Ask]:
    """Ask the compiled program: a line of answer for each line of input."""
    folder = tmp_path_factory.mktemp("cdr")
    shutil.copytree(SITE, folder, dirs_exist_ok=True)
    copy_test_msgs(native, folder / "src" / "test_msgs")
    build(folder, output=folder / "dist", report=Report())
    (folder / "dist" / "host.js").write_text(HOST)
    (folder / "dist" / "empty.html").write_text("<!DOCTYPE html><link rel=icon href=data:,>")
    with serving(folder / "dist") as url:
        page = browser.new_page()
        page.goto(f"{url}empty.html")

        def ask(lines: list[str]) -> list[str]:
            program = f"{url}nodes/cdr_check/cdr_check.jspi"
            text = "".join(f"{line}\n" for line in lines)
            answers: list[str] = page.evaluate(RUN, [program, text])
            assert len(answers) == len(lines), answers[-1:]
            return answers

        yield ask
        page.close()


@pytest.fixture(scope="module")
def types(ask: Ask) -> list[str]:
    return ask(["types"])[0].split()


@pytest.fixture(scope="module")
def messages(native: Native, types: list[str]) -> list[str]:
    """Lines of a type and the bytes that native ROS 2 makes of a random message."""
    return native.run("messages.py", "make", SEED, *types)


def test_messages_are_read_and_written_as_native_ros_2_does(
    native: Native, ask: Ask, messages: list[str]
) -> None:
    answers = ask([f"again {line}" for line in messages])
    refused = [
        f"{line}: {answer}"
        for line, answer in zip(messages, answers, strict=True)
        if not answer.isalnum() or answer == "refused"
    ]
    assert refused == []
    assert differences(native, messages, answers) == []


def test_new_messages_hold_the_defaults_of_their_type(
    native: Native, ask: Ask, types: list[str]
) -> None:
    expected = native.run("messages.py", "default", *types)
    answers = ask([f"default {name}" for name in types])
    assert differences(native, expected, answers) == []


def test_an_empty_message_is_one_byte(ask: Ask) -> None:
    assert ask(["default test_msgs/msg/Empty"]) == ["0001000000"]


@pytest.mark.parametrize(
    ("what", "line"),
    [
        (
            "four values where three are allowed",
            "test_msgs/msg/BoundedSequences 00010000 04000000 01010101",
        ),
        ("nothing", "std_msgs/msg/String "),
        ("a header alone", "std_msgs/msg/String 00010000"),
        ("a text longer than the message", "std_msgs/msg/String 00010000 05000000 61626300"),
        ("a text of four gigabytes", "std_msgs/msg/String 00010000 ffffffff 61626300"),
        ("another encoding", "std_msgs/msg/String 00030000 04000000 61626300"),
    ],
)
def test_bytes_of_another_type_are_refused(ask: Ask, what: str, line: str) -> None:
    name, _, data = line.partition(" ")
    assert ask([f"again {name} {data.replace(' ', '')}"]) == ["refused"]


def test_texts_are_read_as_native_ros_2_reads_them(ask: Ask) -> None:
    short, unterminated = "000100000000000000", "0001000004000000" + b"abcd".hex()
    expected = ["000100000100000000", "0001000005000000" + b"abcd\0".hex()]
    lines = [f"again std_msgs/msg/String {data}" for data in (short[:16], unterminated)]
    assert ask(lines) == expected


def test_a_text_beyond_its_bound_is_neither_read_nor_written(ask: Ask, messages: list[str]) -> None:
    """test_msgs/Strings has an unbounded text first, and then eleven of which some are bounded."""
    text = (40).to_bytes(4, "little") + b"x" * 39 + b"\0"
    data = (b"\0\1\0\0" + text * 13).hex()
    assert ask([f"again test_msgs/msg/Strings {data}"]) == ["refused"]
    assert ask(["too_long"]) == ["error: the length of a string is 23; the maximum is 22"]


def test_no_bytes_make_reading_crash_or_take_more_memory_than_they_are_worth(
    ask: Ask, messages: list[str]
) -> None:
    first = {line.split()[0]: line for line in reversed(messages)}
    # Behind them, zeros: room for many small elements where a length grew.
    inputs = [*first.values(), *(f"{name} 00010000{'00' * 4000}" for name in first)]
    answers = ask([f"fuzz {line} {SEED} 300" for line in inputs])
    assert [answer for answer in answers if not answer.endswith("accepted")] == []
