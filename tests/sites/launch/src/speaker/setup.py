from setuptools import setup

setup(
    name="speaker",
    version="0.1.0",
    packages=["speaker"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/speaker"]),
        ("share/speaker", ["package.xml"]),
    ],
    entry_points={"console_scripts": ["speak = speaker.speak:main"]},
)
