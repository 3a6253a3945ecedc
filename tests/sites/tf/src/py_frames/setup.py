from setuptools import setup

setup(
    name="py_frames",
    version="1.0.0",
    packages=["py_frames"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/py_frames"]),
        ("share/py_frames", ["package.xml"]),
    ],
    entry_points={
        "console_scripts": ["buffer = py_frames.buffer:main", "waiting = py_frames.waiting:main"]
    },
)
