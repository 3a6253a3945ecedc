"""Python nodes in the page, against native rclpy where there is something to compare."""

from __future__ import annotations

import json
import re
import shutil
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from subprocess import CompletedProcess

import pytest
from browser import Built, Serve
from native import Native, copy_test_msgs, differences
from panel import Panel, expect_nothing_left
from paths import SITES
from playwright.sync_api import Browser, Page, expect

from sitegen.commands.build import build
from sitegen.report import Report

SITE = SITES / "python"
SEED = "20240607"
# Programs that end by themselves and print the same everywhere.
PROGRAMS = [
    *("pubsub", "services", "parameters", "policies", "threads", "errors", "data"),
    *("actions", "lifecycle", "graph", "executors", "event_loops", "loops"),
    *("introspection", "goals", "loggers", "overrides", "scheduling", "observers", "outlived"),
    *("ending", "jumps"),
]

# Run a node to its end, and return its lines: a console would keep only the last.
RUN = """async (name) => {
  const { ros } = await import(document.querySelector("script[type=module][src*=rosMain]").src);
  const node = ros.nodes.get(name);
  const lines = [];
  node.addEventListener("lines", (event) => lines.push(...event.detail));
  await new Promise((resolve, reject) => {
    node.addEventListener("state", () => {
      if (node.state === "stopped" || node.state === "failed") resolve();
    });
    const limit = () => reject(new Error(`'${name}' is ${node.state} after two minutes`));
    setTimeout(limit, 120_000);
    node.start();
  });
  return [node.state, lines.map(({ severity, text }) => [severity, text])];
}"""

Lines = list[tuple[str, str]]


def run(page: Page, name: str) -> tuple[str, Lines]:
    """Run a node to its end; return its last state and its lines."""
    state, lines = page.evaluate(RUN, name)
    return state, [(severity, text) for severity, text in lines]


def run_both(
    page: Page, native: Native, program: str, installed: Path
) -> tuple[str, Lines, CompletedProcess[str]]:
    """Run a program in the page and natively, side by side: neither knows of the other."""
    with ThreadPoolExecutor(1) as pool:
        natively = pool.submit(native.call, f"tutorials.{program}:main", installed)
        state, lines = run(page, program)
        return state, lines, natively.result()


def printed(lines: Lines, stream: str = "stdout") -> list[str]:
    return [row for severity, text in lines if severity == stream for row in text.split("\n")]


@pytest.fixture
def page(browser: Browser, serve: Serve, built: Built) -> Page:
    page = browser.new_page()
    page.goto(serve(built(SITE)))
    return page


@pytest.fixture(scope="module")
def native() -> Native:
    return Native()


@pytest.fixture(scope="module")
def installed(built: Built, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the page unpacks for the package is what a robot would have installed."""
    folder = tmp_path_factory.mktemp("installed")
    with zipfile.ZipFile(built(SITE) / "nodes" / "tutorials" / "python.zip") as archive:
        archive.extractall(folder)
    return folder


@pytest.mark.parametrize("program", PROGRAMS)
def test_programs_print_what_native_rclpy_prints(
    page: Page, native: Native, installed: Path, program: str
) -> None:
    state, lines, expected = run_both(page, native, program, installed)
    assert printed(lines) == expected.stdout.splitlines(), expected.stderr
    assert (state == "failed") is (expected.returncode != 0)
    if expected.returncode:
        assert lines[-1] == ("fatal", f"{program}: exited with code {expected.returncode}")


def test_an_exception_is_told_as_python_tells_it(page: Page) -> None:
    state, lines = run(page, "errors")
    assert state == "failed"
    assert printed(lines, "stderr") == [
        "Traceback (most recent call last):",
        '  File "/ros/python/tutorials/errors.py", line 43, in main',
        '    raise ValueError("at the end")',
        "ValueError: at the end",
    ]


def test_what_is_raised_below_rclpy_is_told_as_natively(page: Page) -> None:
    """It is of the class that programs know, and nothing of what stands in for C++ is shown."""
    state, lines = run(page, "ending")
    assert state == "failed"
    told = [line for line in printed(lines, "stderr") if set(line) - set(" ~^")]
    assert [re.sub("0x[0-9a-f]+", "0x", line) for line in told] == [
        "Traceback (most recent call last):",
        '  File "/ros/python/tutorials/ending.py", line 27, in main',
        '    raise LookupError("first")',
        "LookupError: first",
        "During handling of the above exception, another exception occurred:",
        "Traceback (most recent call last):",
        '  File "/ros/python/tutorials/ending.py", line 29, in main',
        "    publisher.publish(String())",
        '  File "/ros/python/rclpy/publisher.py", line 72, in publish',
        "    self.__publisher.publish(msg)",
        "rclpy._rclpy_pybind11.RCLError: Failed to publish: publisher's context is invalid",
        "Exception ignored in atexit callback <function wrong at 0x>:",
        "Traceback (most recent call last):",
        '  File "/ros/python/tutorials/ending.py", line 11, in wrong',
        '    raise ValueError("ignored")',
        "ValueError: ignored",
    ]


def test_what_a_page_has_none_of_is_refused(page: Page) -> None:
    state, lines = run(page, "outside")
    sockets = "sockets are not available in the browser; use topics, services or actions"
    assert (state, [re.sub(r"\[Errno -?\d+\] ", "", line) for line in printed(lines)]) == (
        "stopped",
        [
            "OSError other programs are not available in the browser: 'ls'",
            "OSError other programs are not available in the browser: 'ls'",
            f"gaierror {sockets}",
            f"OSError {sockets}",
            f"OSError {sockets}",
            f"URLError <urlopen error {sockets}>",
            *["ImportError processes are not available in the browser; use threads"] * 2,
            *("None", "None", "None", "3", "1", "None"),
            "None",
            _refused("sys.setprofile"),
            "None",
            *map(_refused, ("sys.monitoring.set_events", "sys._current_frames")),
            _refused("faulthandler.dump_traceback"),
            "7",
        ],
    )


def _refused(name: str) -> str:
    return (
        f"RuntimeError {name}() is not available in the browser while other threads or nodes share "
        "this interpreter; debuggers and profilers need one that runs a single thread"
    )


def test_programs_that_cmake_installs_run_as_python_runs_them(page: Page) -> None:
    state, lines = run(page, "greeter")
    assert (state, printed(lines)) == ("stopped", ["Good morning, World greeter.py True"])
    state, lines = run(page, "plain")
    assert (state, printed(lines)) == ("failed", ["plain"])
    assert lines[-1] == ("fatal", "plain: exited with code 3")


def test_packages_of_pypi_come_along(page: Page) -> None:
    state, lines = run(page, "sorting")
    assert (state, printed(lines)) == ("stopped", ["SortedList([1, 2, 3]) None"])


@pytest.mark.parametrize("name", ["packing", "packed"])
@pytest.mark.firefox
def test_compiled_packages_of_pypi_come_along(page: Page, name: str) -> None:
    """By itself, and in an interpreter that several nodes share."""
    state, lines = run(page, name)
    assert printed(lines) == ["msgpack._cmsgpack {'speeds': [0.5, -1], 'name': 'left'}"], lines
    assert state == "stopped"


WATCH = """async (name) => {
  const { ros } = await import(document.querySelector("script[type=module][src*=rosMain]").src);
  const state = document.querySelector(`section[aria-label="${name}"] .ros-state`);
  window.told = [];
  ros.nodes.get(name).addEventListener("progress", ({ detail: { loaded, total } }) => {
    window.told.push([loaded, total, state.textContent]);
  });
}"""


@pytest.mark.firefox
def test_it_is_told_how_far_python_is_loaded(page: Page) -> None:
    page.evaluate(WATCH, "greeter")
    run(page, "greeter")
    told = page.evaluate("told")
    loaded = [each[0] for each in told]
    assert loaded == sorted(loaded)
    assert told[0][1] > 12_000_000
    # All that was announced came, and no more.
    assert told[-1][:2] == [told[0][1]] * 2
    texts = [each[2] for each in told]
    assert texts[-1] == "starting Python"
    assert all(re.fullmatch(r"loading Python: \d+\.\d of 1\d\.\d MB", each) for each in texts[:-1])


@pytest.mark.parametrize(
    ("file", "status", "words"),
    [
        ("python_stdlib.zip", 0, "check the connection to the site, then start again"),
        ("pyodide.asm.wasm", 404, "the server answered 404; reload the page"),
        ("pyodide.mjs", 0, "check the connection to the site, then start again"),
        ("ros.zip", 404, "the server answered 404; reload the page"),
    ],
)
def test_what_cannot_be_loaded_is_told_and_a_second_start_tries_again(
    page: Page, file: str, status: int, words: str
) -> None:
    pattern = re.compile(rf"/{re.escape(file)}")
    page.context.route(pattern, lambda r: r.fulfill(status=status) if status else r.abort())
    state, lines = run(page, "greeter")
    assert state == "failed"
    [(severity, text)] = lines
    assert severity == "fatal"
    assert text.startswith(f"greeter: {file} could not be loaded") and words in text
    page.context.unroute(pattern)
    assert run(page, "greeter")[0] == "stopped"


def test_stop_is_a_keyboard_interrupt(page: Page) -> None:
    node = Panel(page, "stopping")
    for _ in range(2):
        node.start()
        node.wait_for("spinning")
        node.stop()
        node.wait_for("finally")
        assert node.lines()[-2:] == ["interrupted, ok: False", "finally"]
        node.button("Clear").click()
    expect_nothing_left(page)


def test_who_reads_keys_gets_them_and_is_stopped_while_it_waits(page: Page) -> None:
    node = Panel(page, "keys")
    keyboard = node.panel.get_by_role("textbox")
    questions = node.console.locator("> div", has_text="which key?")
    node.start()
    node.wait_for("while it waits")
    expect(questions).to_have_count(1)
    keyboard.press("i")
    expect(questions).to_have_count(2)
    # In a raw terminal this is a key as others are.
    keyboard.press("Control+c")
    node.expect_state("stopped")
    lines = [line.strip() for line in node.lines() if line != "while it waits"]
    told = ["i: forward, k: stop", "no key yet: []", "which key?", "which key?"]
    assert lines == [*told, "and the terminal is as it was"]
    node.start()
    expect(questions).to_have_count(3)
    node.stop()
    # Before that, the thread that spins may have ended with a traceback, as natively.
    assert node.lines()[-1] == "and the terminal is as it was"


def test_what_is_printed_before_a_computation_is_shown_before_its_end(page: Page) -> None:
    node = Panel(page, "busy")
    node.start()
    node.wait_for("computing")
    node.stop()


def test_a_browser_without_jspi_is_told_which_have_it(
    browser: Browser, serve: Serve, built: Built
) -> None:
    page = browser.new_page()
    page.add_init_script("delete WebAssembly.Suspending; delete WebAssembly.promising;")
    page.goto(serve(built(SITE)))
    node = Panel(page, "pubsub")
    node.start()
    node.expect_state("failed")
    expect(node.console).to_contain_text("Chrome 137, Edge 137, Firefox 153 and newer")


def test_the_extension_has_every_name_of_upstreams(
    page: Page, native: Native, installed: Path
) -> None:
    ours = entries("\n".join(printed(run(page, "entries")[1])))
    theirs = entries(native.call("tutorials.entries:main", installed).stdout)
    assert len(theirs) > 90
    lacking = []
    for name, (inside, number, members) in theirs.items():
        if name not in ours:
            lacking.append(name)
        else:
            lacking += [f"{name}.{one}" for one in inside if one not in ours[name][0]]
            assert (number, members) == ours[name][1:], name
    assert lacking == []


Entries = dict[str, tuple[list[str], object, object]]


def entries(text: str) -> Entries:
    """Read what the program `entries` prints, without what only Python or pybind11 adds."""
    found: Entries = {}
    for line in text.splitlines():
        if not line.startswith("["):
            continue
        name, inside, number, members = json.loads(line)
        if name.startswith("__"):
            continue
        # Enumerations of pybind11 are no classes of Python's enum: their members are compared.
        public = [] if members else [one for one in inside if not one.startswith("_")]
        public = [one for one in public if one not in dir(RuntimeError)]
        found[name] = (public, number, members)
    return found


@pytest.fixture(scope="module")
def vectors(native: Native, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[str]]:
    """A site whose node reads and writes again what native ROS 2 made, and those lines."""
    folder = tmp_path_factory.mktemp("vectors")
    shutil.copytree(SITE.parent / "cdr" / "src" / "test_msgs", folder / "src" / "test_msgs")
    copy_test_msgs(native, folder / "src" / "test_msgs")
    shutil.copytree(SITES / "python_cdr", folder, dirs_exist_ok=True)
    kinds = {"msg": ("",), "srv": ("_Request", "_Response")}
    types = [
        f"test_msgs/{kind}/{file.stem}{part}"
        for kind, parts in kinds.items()
        for file in sorted((folder / "src" / "test_msgs" / kind).glob("*.*"))
        for part in parts
    ]
    lines = native.run("messages.py", "make", SEED, *types)
    data = folder / "src" / "py_cdr" / "py_cdr" / "vectors.txt"
    data.write_text("".join(f"{line}\n" for line in lines))
    build(folder, output=folder / "dist", report=Report())
    return folder / "dist", lines


def test_messages_are_read_and_written_as_native_ros_2_does(
    browser: Browser, serve: Serve, native: Native, vectors: tuple[Path, list[str]]
) -> None:
    folder, lines = vectors
    page = browser.new_page()
    page.goto(serve(folder))
    state, output = run(page, "again")
    answers = printed(output)
    assert state == "stopped", output[-5:]
    assert len(answers) == len(lines) > 200
    assert differences(native, lines, answers) == []
    # Bytes that end too early, or claim to be longer than they are, are no message.
    assert run(page, "refuse")[1][-1] == ("stdout", "all refused")
