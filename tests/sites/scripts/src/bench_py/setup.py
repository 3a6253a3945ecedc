from setuptools import setup

setup(
    name="bench_py",
    version="0.1.0",
    packages=["bench_py"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/bench_py"]),
        ("share/bench_py", ["package.xml"]),
    ],
    entry_points={"console_scripts": ["helper = bench_py.helper:main"]},
)
