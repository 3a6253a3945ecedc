from setuptools import setup

setup(
    name="teller_py",
    version="1.0.0",
    packages=["teller_py"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/teller_py"]),
        ("share/teller_py", ["package.xml"]),
    ],
    entry_points={"console_scripts": ["tell = teller_py.tell:main"]},
)
