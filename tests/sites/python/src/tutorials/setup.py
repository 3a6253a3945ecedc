import os
from glob import glob

from setuptools import find_packages, setup

package_name = "tutorials"

setup(
    name=package_name,
    version="0.1.0",
    packages=find_packages(exclude=["test"]),
    package_data={package_name: ["words.txt"]},
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{package_name}"]),
        (os.path.join("share", package_name), ["package.xml"]),
        (os.path.join("share", package_name, "config"), glob("config/*.yaml")),
    ],
    entry_points={
        "console_scripts": [
            "pubsub = tutorials.pubsub:main",
            "services = tutorials.services:main",
            "parameters = tutorials.parameters:main",
            "policies = tutorials.policies:main",
            "threads = tutorials.threads:main",
            "errors = tutorials.errors:main",
            "stopping = tutorials.stopping:main",
            "data = tutorials.data:main",
            "actions = tutorials.actions:main",
            "lifecycle = tutorials.lifecycle:main",
            "graph = tutorials.graph:main",
            "executors = tutorials.executors:main",
            "event_loops = tutorials.event_loops:main",
            "loops = tutorials.loops:main",
            "busy = tutorials.busy:main",
            "introspection = tutorials.introspection:main",
            "goals = tutorials.goals:main",
            "loggers = tutorials.loggers:main",
            "observers = tutorials.observers:main",
            "scheduling = tutorials.scheduling:main",
            "overrides = tutorials.overrides:main",
            "outlived = tutorials.outlived:main",
            "ending = tutorials.ending:main",
            "jumps = tutorials.jumps:main",
            "spinning = tutorials.spinning:main",
            "serializing = tutorials.serializing:main",
            "entries = tutorials.entries:main",
        ],
    },
)
