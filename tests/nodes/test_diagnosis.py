"""What CMake says, in the words of sitegen."""

from __future__ import annotations

from pathlib import Path

from sitegen.model import Package
from sitegen.nodes.cpp.diagnosis import Diagnosis


def test_headers_that_authors_install_are_told_with_how(tmp_path: Path) -> None:
    package = Package("arm", tmp_path / "src" / "arm", "ament_cmake", (), (), ())
    said = 'Could not find a package configuration file provided by "Eigen3" with any of'
    assert Diagnosis(tmp_path, package).of_cmake(said) == [
        "src/arm/CMakeLists.txt: 'arm' needs 'Eigen3', which is not installed "
        "(pip install 'ros-sitegen[eigen]', or apt-get install libeigen3-dev)"
    ]
