from setuptools import find_packages, setup

package_name = "instruments"

setup(
    name=package_name,
    version="0.1.0",
    packages=find_packages(),
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{package_name}"]),
        (f"share/{package_name}", ["package.xml"]),
    ],
    entry_points={
        "console_scripts": [
            "counter = instruments.counter:main",
            "frames = instruments.frames:main",
            "managed = instruments.managed:main",
        ],
    },
)
