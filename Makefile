# Two commands do all of their own set-up: `make demo` and `make test`.
PYTHON ?= python3
BIN := .venv/bin
PORT ?= 8000
# How many tests run at once. Most wait for browsers most of the time.
AT_ONCE ?= 2

.PHONY: demo serve check test test-all test-firefox lint bench clean

demo: .venv/ready .venv/emscripten
	$(BIN)/sitegen build
	@echo
	@echo "Now serve it:  make serve"

serve:
	@test -d dist || { echo "there is no dist/ yet: make demo"; exit 1; }
	@echo "http://localhost:$(PORT)/ (Ctrl-C ends it)"
	@$(PYTHON) -m http.server --bind 127.0.0.1 --directory dist $(PORT)

TOOLS := .venv/ready .venv/emscripten .venv/chromium .venv/headless .venv/firefox .venv/webkit .venv/rowe \
  .venv/headers

RUN := $(BIN)/python tests/support/run.py --at-once $(AT_ONCE) --begun $(shell date +%s)

# While working: the linters, and the tests nearest to what changed since main.
check: $(TOOLS) lint
	$(BIN)/python tests/support/changed.py --at-once $(AT_ONCE)

# All of it in Chromium with JSPI, and in each other browser and engine what differs there.
test: $(TOOLS) lint
	$(RUN) --compile

# All of it in all browsers and engines, which takes much longer.
test-all: $(TOOLS) lint
	$(RUN) --compile --all

# All of it in Firefox, except for what only Chromium has.
test-firefox: $(TOOLS)
	$(RUN) --firefox

lint: .venv/ready node_modules/.package-lock.json
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	npm run --silent check

bench: .venv/ready .venv/emscripten .venv/chromium .venv/mkdocs .venv/rowe .venv/headers
	$(BIN)/python -m bench

clean:
	rm -rf .venv .test node_modules dist sitegen/ros

# Stamps: each is made again when what it depends on has changed.

.venv/ready: pyproject.toml constraints.txt ros.txt hatch_build.py package-lock.json vendor.mjs bundle.mjs bytecode.mjs
	@$(PYTHON) -m ensurepip --version > /dev/null 2>&1 || ./install python3-venv
	$(PYTHON) -m venv .venv
	$(BIN)/pip install --quiet --constraint constraints.txt --editable '.[dev]'
	touch $@

.venv/mkdocs: .venv/ready
	$(BIN)/pip install --quiet --constraint constraints.txt --editable '.[dev,bench]'
	touch $@

.venv/emscripten: | .venv/ready
	@command -v em++ > /dev/null || ./install emscripten
	touch $@

.venv/chromium: | .venv/ready
	@test -x /usr/bin/chromium || ./install chromium
	touch $@

# Chromium without a window: a page opens in a third of the time.
.venv/headless: | .venv/ready
	@test -x /usr/bin/chromium-headless-shell || ./install chromium-headless-shell
	touch $@

.venv/firefox: | .venv/ready
	@test -x /usr/bin/firefox-esr || ./install firefox-esr
	touch $@

.venv/webkit: | .venv/ready
	@test -x /usr/bin/WebKitWebDriver || ./install webkit2gtk-driver
	@test -x /usr/bin/Xvfb || ./install xvfb
	touch $@

# Libraries of which programs need only the headers.
.venv/headers: | .venv/ready
	@test -e /usr/include/boost/version.hpp || ./install libboost-dev
	@test -e /usr/include/fmt/core.h || ./install libfmt-dev
	@test -e /usr/include/nlohmann/json.hpp || ./install nlohmann-json3-dev
	@test -e /usr/include/spdlog/version.h || ./install libspdlog-dev
	touch $@

# What compiles and checks rowe in C.
.venv/rowe: | .venv/ready
	@command -v gcc > /dev/null || ./install gcc
	@command -v valgrind > /dev/null || ./install valgrind
	@test -e /usr/include/libwebsockets.h || ./install libwebsockets-dev
	@test -e /usr/include/json-c/json.h || ./install libjson-c-dev
	touch $@

node_modules/.package-lock.json: package.json package-lock.json
	npm ci --silent --no-audit --no-fund
	touch $@
