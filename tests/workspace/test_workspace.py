from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from sitegen.errors import SiteError
from sitegen.model import BuildSettings, Package
from sitegen.workspace import scan, with_dependencies, with_plugins


def write(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(dedent(text), encoding="utf-8")
    return folder


def xml(name: str, inside: str = "") -> str:
    return f"<package format='3'><name>{name}</name>{inside}</package>"


def listing(tmp_path: Path, cmake: str) -> Package:
    files = {"src/demo/package.xml": xml("demo"), "src/demo/CMakeLists.txt": cmake}
    return scan(write(tmp_path, files))["demo"]


def problems(folder: Path) -> list[str]:
    with pytest.raises(SiteError) as caught:
        scan(folder)
    return caught.value.lines


def test_a_package_is_what_its_files_say(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "src/cpp_pubsub/package.xml": """\
                <?xml version="1.0"?>
                <?xml-model href="http://download.ros.org/schema/package_format3.xsd"?>
                <package format="3">
                  <name>cpp_pubsub</name>
                  <version>0.1.0</version>
                  <buildtool_depend>ament_cmake</buildtool_depend>
                  <depend>rclcpp</depend>
                  <depend condition="$ROS_VERSION == 2"> std_msgs </depend>
                  <build_depend>rclcpp</build_depend>
                  <exec_depend>interfaces</exec_depend>
                  <test_depend>ament_lint_auto</test_depend>
                  <doc_depend>doxygen</doc_depend>
                  <member_of_group>rosidl_interface_packages</member_of_group>
                  <export><build_type>ament_cmake</build_type></export>
                </package>
                """,
            "src/cpp_pubsub/CMakeLists.txt": "add_executable(talker src/talker.cpp)",
        },
    )
    assert scan(tmp_path) == {
        "cpp_pubsub": Package(
            name="cpp_pubsub",
            path=tmp_path / "src/cpp_pubsub",
            build_type="ament_cmake",
            depends=("ament_cmake", "rclcpp", "std_msgs", "interfaces"),
            executables=("talker",),
            interfaces=(),
            version="0.1.0",
            sources={"talker": ("src/talker.cpp",)},
            share=dict.fromkeys(
                (
                    "share/cpp_pubsub/package.xml",
                    "share/ament_index/resource_index/packages/cpp_pubsub",
                ),
                tmp_path / "src/cpp_pubsub/package.xml",
            ),
        )
    }


def test_packages_are_found_where_colcon_finds_them(tmp_path: Path) -> None:
    package = {"package.xml": xml("x")}
    here = ["a", "deep/er/b"]
    not_here = [
        *("build/x", "install/x", "log/x", "dist/x", "node_modules/x", ".venv/x", "deep/.git/x"),
        *("ignored/x", "a/inside_of_a_package"),
    ]
    for path in [*here, *not_here]:
        name = path.replace("/", "_").replace(".", "")
        write(tmp_path / path, {**package, "package.xml": xml(f"p_{name}")})
    write(tmp_path, {"ignored/COLCON_IGNORE": ""})
    (tmp_path / "linked").symlink_to(tmp_path / "a")
    assert list(scan(tmp_path)) == ["p_a", "p_deep_er_b"]


@pytest.mark.parametrize(
    ("export", "cmake", "build_type"),
    [
        ("<build_type>ament_python</build_type>", False, "ament_python"),
        ("<build_type>cmake</build_type>", True, "cmake"),
        (
            '<build_type condition="$ROS_VERSION == 1">catkin</build_type>'
            '<build_type condition="$ROS_VERSION == 2">ament_cmake</build_type>',
            True,
            "ament_cmake",
        ),
        ("", True, "ament_cmake"),
        ("", False, "catkin"),
    ],
)
def test_the_build_type(tmp_path: Path, export: str, cmake: bool, build_type: str) -> None:
    write(tmp_path, {"package.xml": xml("demo", f"<export>{export}</export>")})
    if cmake:
        write(tmp_path, {"CMakeLists.txt": ""})
    assert scan(tmp_path)["demo"].build_type == build_type


@pytest.mark.parametrize(
    ("cmake", "executables"),
    [
        ("add_executable(talker src/talker.cpp)", ("talker",)),
        ("ADD_EXECUTABLE (\n  talker # the first\n  a.cpp b.cpp)\n", ("talker",)),
        ('add_executable("talker" a.cpp)\nadd_executable(talker a.cpp)', ("talker",)),
        ("# add_executable(old a.cpp)\nadd_executable(new a.cpp)", ("new",)),
        ("#[[ add_executable(old\n a.cpp) ]]\n#[=[ ]] add_executable(old) ]=]", ()),
        ('message("add_executable(old) # ")\nadd_executable(new a.cpp)', ("new",)),
        ("message([[\n)add_executable(old a.cpp)\n]])", ()),
        ("if(NOT (A AND B))\nadd_executable(one a.cpp)\nendif()", ("one",)),
        ("add_executable(tool IMPORTED)\nadd_executable(a::b ALIAS b)", ()),
        ("project(demo_nodes)\nadd_executable(${PROJECT_NAME}_a a.cpp)", ("demo_nodes_a",)),
        ("add_executable(${PROJECT_NAME} a.cpp)", ("demo",)),
        ("add_executable(fixed a.cpp)\nadd_executable(${NAME} a.cpp)", None),
        ("set(NAME ${OTHER})\nadd_executable(${NAME}_a a.cpp)", None),
        ("set(NAME a CACHE STRING what)\nadd_executable(${NAME}_a a.cpp)", ("a_a",)),
        ("if(WIN32)\nset(NAME a)\nendif()\nadd_executable(${NAME} a.cpp)", None),
        ("set(NAME a)\nstring(TOUPPER x NAME)\nadd_executable(${NAME} a.cpp)", None),
        ("foreach(name a b)\nadd_executable(${name} a.cpp)\nendforeach()", ("a", "b")),
        (
            "set(names c d)\nforeach(name IN ITEMS a LISTS names)\nforeach(n RANGE 1)\n"
            "add_executable(${name}_${n} a.cpp)\nendforeach()\nendforeach()",
            ("a_0", "a_1", "c_0", "c_1", "d_0", "d_1"),
        ),
        (
            "execute_process(COMMAND ls OUTPUT_VARIABLE names)\n"
            "foreach(name ${names})\nadd_executable(${name} a.cpp)\n",
            None,
        ),
        (
            "function(demo folder target)\nadd_executable(${target} ${folder}/a.cpp ${ARGN})\n"
            "endfunction()\nDemo(topics talker b.cpp)\ndemo(topics listener)",
            ("talker", "listener"),
        ),
        (
            "macro(one name)\nset(${name}_made ${name})\nadd_executable(${ARGV1} a.cpp)\n"
            "endmacro()\none(a ${a})\none(b ${b})",
            None,
        ),
        ("macro(again)\nadd_executable(a a.cpp)\nagain()\nendmacro()\nagain()", ("a",)),
        (
            "if(BUILD_TESTING)\nif(A)\nadd_executable(test a.cpp)\nelse()\nendif()\n"
            "function(never)\nendfunction()\nelse()\nadd_executable(real a.cpp)\nendif()",
            ("real",),
        ),
        ("add_subdirectory(${WHERE})", None),
        ("ament_auto_add_executable(talker a.cpp)", ("talker",)),
        (
            'rclcpp_components_register_node(talker_component\n  PLUGIN "demo::Talker"\n'
            "  EXECUTABLE talker)",
            ("talker",),
        ),
        ("add_executable(unfinished", ()),
        (
            'add_executable(a a.cpp)\nset_target_properties(a PROPERTIES PREFIX "" OUTPUT_NAME b)',
            ("b",),
        ),
        (
            "add_executable(a a.cpp)\nset_property(TARGET a PROPERTY OUTPUT_NAME ${PROJECT_NAME})",
            ("demo",),
        ),
        ("add_executable(a a.cpp)\nset_target_properties(a PROPERTIES OUTPUT_NAME ${X})", None),
        (
            'option(X "x" OFF)\nif(X)\nadd_executable(a a.cpp)\nelse()\nadd_executable(b b.cpp)\n'
            "endif()\nif(NOT X)\nadd_executable(c c.cpp)\nendif()",
            ("b", "c"),
        ),
        (
            'option(X "x")\nif(X)\nadd_executable(a a.cpp)\nelseif(MORE)\nadd_executable(b b.cpp)\n'
            'set(N d)\nelse()\nadd_executable(c c.cpp)\nendif()\noption(Z "z" ON)\nif(Z)\n'
            "add_executable(e e.cpp)\nelse()\nadd_executable(f f.cpp)\nendif()",
            ("b", "c", "e"),
        ),
        ("foreach(n RANGE 999999999999)\nendforeach()\nadd_executable(a a.cpp)", ("a",)),
    ],
)
def test_executables(tmp_path: Path, cmake: str, executables: tuple[str, ...] | None) -> None:
    assert listing(tmp_path, cmake).executables == executables


def test_settings_of_a_build_decide_what_is_read(tmp_path: Path) -> None:
    cmake = """\
option(X "x" OFF)
option(Y "y" ON)
set(NAME a CACHE STRING "")
set(OTHER b CACHE STRING "" FORCE)
if(X)
  add_executable(x x.cpp)
endif()
if(Y)
  add_executable(y y.cpp)
endif()
add_executable(${NAME} main.cpp)
add_executable(${OTHER} main.cpp)
"""
    folder = write(tmp_path, {"demo/package.xml": xml("demo"), "demo/CMakeLists.txt": cmake})
    assert scan(folder)["demo"].executables == ("y", "a", "b")
    given = BuildSettings(("-DX:BOOL=on", "-DY=0", "-DNAME=c", "-DOTHER=d"))
    found = scan(folder, {"demo": given, "elsewhere": BuildSettings(("-DX=OFF",))})["demo"]
    assert found.executables == ("x", "c", "b")
    assert found.settings == given


def test_executables_of_included_files(tmp_path: Path) -> None:
    write(
        tmp_path / "src/demo",
        {
            "nodes/CMakeLists.txt": "add_executable(inner a.cpp)\nadd_subdirectory(../nodes)",
            "cmake/more.cmake": "add_executable(more a.cpp)",
        },
    )
    cmake = "add_subdirectory(nodes)\ninclude(${CMAKE_CURRENT_SOURCE_DIR}/cmake/more.cmake)\n"
    package = listing(tmp_path, f"include(GNUInstallDirs)\n{cmake}")
    assert package.executables == ("inner", "more")


@pytest.mark.parametrize(
    ("cmake", "interfaces"),
    [
        (
            'rosidl_generate_interfaces(${PROJECT_NAME}\n  "msg/Num.msg"\n  srv/Add.srv # sum\n'
            "  action/Go.action idl/Raw.idl\n  DEPENDENCIES geometry_msgs other.msg)",
            ("msg/Num.msg", "srv/Add.srv", "action/Go.action", "idl/Raw.idl"),
        ),
        (
            'set(msgs "msg/A.msg" "msg/B.msg")\nlist(APPEND msgs msg/C.msg)\n'
            "rosidl_generate_interfaces(${PROJECT_NAME} ${msgs} ${msgs})",
            ("msg/A.msg", "msg/B.msg", "msg/C.msg"),
        ),
        (
            'set(msgs "msg/A.msg;msg/B.msg")\nrosidl_generate_interfaces(x ${msgs})',
            ("msg/A.msg", "msg/B.msg"),
        ),
        ("rosidl_generate_interfaces(x ${found_by_glob})", ()),
    ],
)
def test_interfaces(tmp_path: Path, cmake: str, interfaces: tuple[str, ...]) -> None:
    assert listing(tmp_path, cmake).interfaces == interfaces


def test_all_that_is_wrong_is_said_at_once(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "a/package.xml": "<package>\n  <name>twin</name>\n</package>",
            "b/package.xml": "<package>\n\n  <name>twin</name>\n</package>",
            "c/package.xml": "<package>\n  <name>open\n</package>",
            "d/package.xml": "<package>\n  <version>1.0.0</version>\n</package>",
            "e/package.xml": "<package>\n  <name>../up</name>\n</package>",
            "f/package.xml": """\
                <?xml version="1.0"?>
                <!DOCTYPE package [<!ENTITY all SYSTEM "/etc/passwd">]>
                <package><name>&all;</name></package>
                """,
            "g/package.xml": "",
        },
    )
    assert problems(tmp_path) == [
        "b/package.xml:3: name: package 'twin' is also in 'a'; rename or remove one of the two",
        "c/package.xml:3: xml: mismatched tag; check the tags here and above",
        "d/package.xml:1: name: missing; write it like <name>my_robot</name>",
        "e/package.xml:2: name: '../up' is not a valid package name; "
        "write it like <name>my_robot</name>",
        "f/package.xml:2: xml: a document type declaration is not allowed; "
        "remove the line <!DOCTYPE …>",
        "g/package.xml:1: xml: no element found; check the tags here and above",
    ]


def test_dependencies_come_first(tmp_path: Path) -> None:
    packages = scan(
        write(
            tmp_path,
            {
                "app/package.xml": xml("app", "<depend>rclcpp</depend><depend>lib</depend>"),
                "lib/package.xml": xml("lib", "<depend>msgs</depend>"),
                "msgs/package.xml": xml("msgs"),
                "other/package.xml": xml("other", "<depend>app</depend>"),
            },
        )
    )
    assert [package.name for package in with_dependencies(packages, "app")] == [
        *("msgs", "lib", "app")
    ]


def test_programs_are_linked_with_plugins_of_packages_that_need_theirs(tmp_path: Path) -> None:
    square = "pluginlib_export_plugin_description_file(base square.xml)"
    packages = scan(
        write(
            tmp_path,
            {
                "base/package.xml": xml("base", "<depend>pluginlib</depend>"),
                "pluginlib/package.xml": xml("pluginlib"),
                "square/package.xml": xml("square", "<depend>base</depend><depend>sides</depend>"),
                "square/CMakeLists.txt": square,
                "sides/package.xml": xml("sides"),
                "other/package.xml": xml("other", "<depend>base</depend>"),
                "other/CMakeLists.txt": "pluginlib_export_plugin_description_file(else else.xml)",
            },
        )
    )
    *needs, base = with_plugins(packages, packages["base"])
    assert base.linked == ("square",)
    assert [package.name for package in needs] == ["pluginlib", "sides", "base", "square"]
    assert not needs[1].linked
    *needs, other = with_plugins(packages, packages["other"])
    assert other.linked == ("square",)
    *needs, plugins = with_plugins(packages, packages["square"])
    assert plugins.linked == ()


def test_programs_with_behavior_trees_are_linked_with_nodes_of_trees(tmp_path: Path) -> None:
    """They open their libraries themselves, without pluginlib."""
    nodes = """\
foreach(one ${libraries})
  target_compile_definitions(${one} PRIVATE BT_PLUGIN_EXPORT)
endforeach()
"""
    depends = "<depend>behaviortree_cpp_v3</depend>"
    packages = scan(
        write(
            tmp_path,
            {
                "trees/package.xml": xml("behaviortree_cpp_v3"),
                "trees/CMakeLists.txt": nodes,  # examples of its own
                "leaves/package.xml": xml("leaves", depends),
                "leaves/CMakeLists.txt": nodes,
                "robot/package.xml": xml("robot", depends),
                "other/package.xml": xml("other"),
            },
        )
    )
    *needs, robot = with_plugins(packages, packages["robot"])
    assert robot.linked == ("leaves",)
    assert [package.name for package in needs] == ["behaviortree_cpp_v3", "leaves"]
    for name in ("other", "behaviortree_cpp_v3"):
        assert with_plugins(packages, packages[name])[-1].linked == ()


def test_programs_are_linked_with_plugins_of_plugins(tmp_path: Path) -> None:
    """A controller of Nav2 has plugins for generators and critics, which controllers load."""
    exports = "pluginlib_export_plugin_description_file({} plugins.xml)".format
    packages = scan(
        write(
            tmp_path,
            {
                "base/package.xml": xml("base", "<depend>pluginlib</depend>"),
                "pluginlib/package.xml": xml("pluginlib"),
                "critics/package.xml": xml("critics", "<depend>local</depend>"),
                "critics/CMakeLists.txt": exports("local"),
                "local/package.xml": xml("local", "<depend>base</depend>"),
                "local/CMakeLists.txt": exports("base"),
            },
        )
    )
    *needs, base = with_plugins(packages, packages["base"])
    assert base.linked == ("local", "critics")
    assert [package.name for package in needs] == ["pluginlib", "base", "local", "critics"]


def test_a_cycle_of_dependencies_is_an_error(tmp_path: Path) -> None:
    packages = scan(
        write(
            tmp_path,
            {
                "a/package.xml": xml("a", "<depend>b</depend>"),
                "b/package.xml": xml("b", "<depend>c</depend>"),
                "c/package.xml": xml("c", "<depend>b</depend>"),
            },
        )
    )
    with pytest.raises(SiteError) as caught:
        with_dependencies(packages, "a")
    assert caught.value.lines == [
        "package.xml of 'b': packages depend on each other in a cycle: b → c → b; "
        "remove one <depend>"
    ]


def test_below_the_root_a_folder_may_be_called_as_one_of_colcon(tmp_path: Path) -> None:
    write(tmp_path, {"src/log/package.xml": xml("logger"), "log/package.xml": xml("left_over")})
    assert scan(tmp_path).keys() == {"logger"}


def test_tags_count_where_their_condition_holds(tmp_path: Path) -> None:
    inside = (
        '<depend condition="$ROS_VERSION == 1">roscpp</depend>'
        "<depend condition=\"$ROS_VERSION == 2 and $ROS_DISTRO >= 'humble'\">rclcpp</depend>"
        "<export><build_type condition='$ROS_VERSION == 1'>catkin</build_type>"
        "<build_type condition='$ROS_VERSION == 2'>ament_python</build_type></export>"
    )
    package = scan(write(tmp_path, {"a/package.xml": xml("a", inside)}))["a"]
    assert package.depends == ("rclcpp",)
    assert package.build_type == "ament_python"


def test_an_invalid_condition_is_a_problem(tmp_path: Path) -> None:
    inside = "\n<depend condition='ROS2'>rclcpp</depend>"
    write(tmp_path, {"a/package.xml": xml("a", inside)})
    assert problems(tmp_path) == [
        "a/package.xml:2: depend: 'ROS2' is not a valid condition; "
        "write it like '$ROS_VERSION == 2'"
    ]
