from setuptools import find_packages, setup

package_name = "py_artist"

setup(
    name=package_name,
    version="0.1.0",
    packages=find_packages(exclude=["test"]),
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
        ("share/" + package_name, ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="Your name",
    maintainer_email="you@example.com",
    description="A node that lets a turtle draw",
    license="Apache-2.0",
    entry_points={
        "console_scripts": [
            "star = py_artist.star:main",
        ],
    },
)
