from setuptools import setup

setup(
    name="mine",
    version="0.1.0",
    packages=["mine"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/mine"]),
        ("share/mine", ["package.xml"]),
    ],
)
