from setuptools import setup

setup(
    name="probe_py",
    version="1.0.0",
    packages=["probe_py"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/probe_py"]),
        ("share/probe_py", ["package.xml"]),
    ],
    entry_points={"console_scripts": ["probe = probe_py.probe:main"]},
)
