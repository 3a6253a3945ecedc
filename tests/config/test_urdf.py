"""The description of a robot as a key of a node."""

from __future__ import annotations

from pathlib import Path

import pytest

from sitegen import config
from sitegen.errors import SiteError

SITE = """\
site: {{title: Test}}
nodes:
  robot: {{package: robot_state_publisher, executable: robot_state_publisher, urdf: {0}}}
pages:
  - {{path: /, title: Test, content: [{{buttons: robot}}]}}
  - {{path: again/, title: Test, content: [{{buttons: robot}}]}}
"""
XACRO = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="folder" value="$(find arm)"/>
  <link name="base"><visual><geometry>
    <mesh filename="file://${{folder}}/meshes/it's.stl"/>
  </geometry></visual></link>{0}
</robot>
"""


@pytest.fixture
def site(tmp_path: Path) -> Path:
    package = tmp_path / "src/arm"
    (package / "urdf").mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>arm</name></package>")
    (package / "urdf/arm.urdf.xacro").write_text(XACRO.format(""))
    (tmp_path / "site.yaml").write_text(SITE.format("src/arm/urdf/arm.urdf.xacro"))
    return tmp_path


def problems(site: Path) -> list[str]:
    with pytest.raises(SiteError) as wrong:
        config.load(site / "site.yaml")
    return wrong.value.lines


def test_a_description_is_a_parameter_with_the_paths_of_the_page(site: Path) -> None:
    for page in config.load(site / "site.yaml").pages:
        text = page.nodes["robot"].parameters["robot_description"]
        assert "file:///ros/share/arm/meshes/it's.stl" in text
        assert str(site) not in text


def test_a_description_that_cannot_be_read_is_an_error_of_its_node(site: Path) -> None:
    (site / "src/arm/urdf/arm.urdf.xacro").write_text(XACRO.format("$(arg length)"))
    [line] = problems(site)
    assert line.startswith("site.yaml:3: urdf: xacro: arm.urdf.xacro: Undefined")
    (site / "site.yaml").write_text(SITE.format("src/arm/urdf/arm.xacro"))
    assert problems(site) == [
        "site.yaml:3: nodes.robot.urdf: no file 'src/arm/urdf/arm.xacro'; did you mean "
        "'src/arm/urdf/arm.urdf.xacro'?"
    ]
