"""The data types that the stages of a build pass to each other."""

from __future__ import annotations

from sitegen.model.content import Cell, Layout, Leaf, Markdown, Part, Source, Widget, leaves
from sitegen.model.launch import Argument, Effect, Event, Handler, Launch
from sitegen.model.node import Component, Container, Cpp, Kind, Node, Prebuilt, Python, Ros2wasm
from sitegen.model.package import BuildSettings, Fault, Package, Setup
from sitegen.model.program import BROWSERS, Artifact, Build, Program, Programs
from sitegen.model.site import Connect, Deploy, Look, NavItem, Page, Pyodide, Site

__all__ = [
    "BROWSERS",
    "Argument",
    "Artifact",
    "Build",
    "BuildSettings",
    "Cell",
    "Component",
    "Connect",
    "Container",
    "Cpp",
    "Deploy",
    "Effect",
    "Event",
    "Fault",
    "Handler",
    "Kind",
    "Launch",
    "Layout",
    "Leaf",
    "Look",
    "Markdown",
    "NavItem",
    "Node",
    "Package",
    "Page",
    "Part",
    "Prebuilt",
    "Program",
    "Programs",
    "Pyodide",
    "Python",
    "Ros2wasm",
    "Setup",
    "Site",
    "Source",
    "Widget",
    "leaves",
]
