"""Libraries of which single sources need what no page can have."""

from __future__ import annotations

from pathlib import Path

from packages import Workspace

from sitegen.nodes.cpp import leftout
from sitegen.nodes.cpp.leftout import LeftOut

NO_OPENCV = "src/tools/CMakeLists.txt: 'tools' needs 'OpenCV', which has no build for the page"
TOOLS = """\
    find_package(OpenCV REQUIRED)
    add_library(tools {})
    target_include_directories(tools PUBLIC
      $<BUILD_INTERFACE:${{CMAKE_CURRENT_SOURCE_DIR}}/include> $<INSTALL_INTERFACE:include>)
    install(DIRECTORY include/ DESTINATION include)
    install(TARGETS tools EXPORT toolsTargets ARCHIVE DESTINATION lib)
    ament_export_targets(toolsTargets)
    add_executable(plain src/plain.cpp)
    target_link_libraries(plain tools)
    """
USER = """\
    find_package(tools REQUIRED)
    foreach(program plain seeing)
      add_executable(${program} src/${program}.cpp)
      target_link_libraries(${program} tools::tools)
    endforeach()
    """


def tools(workspace: Workspace, sources: str = "src/add.cpp src/camera.cpp src/lens.cpp") -> None:
    workspace.package("tools", TOOLS.format(sources))
    workspace.write(
        "src/tools/include/tools/tools.hpp",
        "#pragma once\nint add(int, int);\nstruct Camera { virtual ~Camera(); int look(); };\n",
    )
    workspace.write("src/tools/src/add.cpp", "int add(int a, int b) { return a + b; }\n")
    workspace.write("src/tools/src/image.hpp", "#include <opencv2/core.hpp>\n")
    workspace.write(
        "src/tools/src/camera.cpp",
        """\
        #include "tools/tools.hpp"
        #include "image.hpp"
        Camera::~Camera() = default;
        int Camera::look() { return cv::Mat().rows; }
        """,
    )
    workspace.write("src/tools/src/lens.cpp", '#include "image.hpp"\ncv::Mat lens;\n')
    adds = '#include "tools/tools.hpp"\nint main() { return add(1, 2); }\n'
    workspace.write("src/tools/src/plain.cpp", adds)
    workspace.package("user", USER, depends="tools")
    workspace.write("src/user/src/plain.cpp", adds)
    workspace.write(
        "src/user/src/seeing.cpp",
        '#include "tools/tools.hpp"\nint main() { return Camera().look(); }\n',
    )


def test_programs_that_need_none_of_their_functions_are_built(workspace: Workspace) -> None:
    tools(workspace)
    workspace.site("tools/plain", "user/plain")
    assert {"tools/plain", "user/plain"} <= {*workspace.build()}
    assert workspace.build() == []


def test_programs_that_need_their_functions_say_what_is_missing(workspace: Workspace) -> None:
    tools(workspace)
    workspace.site("user/plain", "user/seeing")
    assert workspace.problems() == [NO_OPENCV]


def test_a_library_of_which_nothing_is_left_is_not_built(workspace: Workspace) -> None:
    tools(workspace, "src/camera.cpp src/lens.cpp")
    workspace.site("tools/plain")
    assert workspace.problems() == [NO_OPENCV]


def test_other_errors_are_told(workspace: Workspace) -> None:
    tools(workspace)
    workspace.write("src/tools/src/add.cpp", "int add(int a, int b) { return a + c; }\n")
    workspace.site("tools/plain")
    [problem] = workspace.problems()
    assert problem.startswith("src/tools/src/add.cpp:1:36: could not compile: use of undeclared")


def test_a_library_that_is_built_nevertheless_is_left_out_once(tmp_path: Path) -> None:
    """Which of its sources fails first can differ from build to build, and so what it lacks."""
    (tmp_path / "optional.txt").write_text("tools")
    camera, cloud = ({"tools": {name: [f"{name}: {NO_OPENCV}"]}} for name in ("camera", "cloud"))
    found = leftout.more(tmp_path, camera)
    assert found == LeftOut(libraries={"tools": [f"camera: {NO_OPENCV}"]})
    found.keep(tmp_path)
    assert leftout.more(tmp_path, cloud) is None


def test_groot_is_replaced_in_behavior_trees(workspace: Workspace) -> None:
    workspace.package(
        "behaviortree_cpp",
        """\
        add_library(behaviortree_cpp src/tree.cpp src/loggers/groot2_publisher.cpp)
        target_include_directories(behaviortree_cpp PUBLIC include)
        add_executable(groot src/main.cpp)
        target_link_libraries(groot behaviortree_cpp)
        """,
        main="""\
        #include "behaviortree_cpp/loggers/groot2_publisher.h"
        int main() {
          BT::Tree tree;
          BT::Groot2Publisher(tree).setMaxHeartbeatDelay(std::chrono::milliseconds(1));
        }
        """,
    )
    workspace.write(
        "src/behaviortree_cpp/include/behaviortree_cpp/loggers/groot2_publisher.h",
        """\
        #pragma once
        #include <chrono>
        #include <memory>
        namespace BT {
        using Duration = std::chrono::nanoseconds;
        enum class NodeStatus { IDLE };
        struct TreeNode { };
        struct Tree { TreeNode * rootNode() const; };
        struct StatusChangeLogger {
          explicit StatusChangeLogger(TreeNode *) { }
          virtual ~StatusChangeLogger() = default;
          virtual void callback(Duration, const TreeNode &, NodeStatus, NodeStatus) = 0;
          virtual void flush() = 0;
        };
        class Groot2Publisher : public StatusChangeLogger {
        public:
          explicit Groot2Publisher(const Tree & tree, unsigned port = 1667);
          ~Groot2Publisher() override;
          void setMaxHeartbeatDelay(std::chrono::milliseconds delay);
          std::chrono::milliseconds maxHeartbeatDelay() const;
        private:
          void callback(Duration, const TreeNode &, NodeStatus, NodeStatus) override;
          void flush() override;
          struct PImpl;
          std::unique_ptr<PImpl> _p;
        };
        }
        """,
    )
    workspace.write(
        "src/behaviortree_cpp/src/tree.cpp",
        '#include "behaviortree_cpp/loggers/groot2_publisher.h"\n'
        "BT::TreeNode * BT::Tree::rootNode() const { return nullptr; }\n",
    )
    workspace.write("src/behaviortree_cpp/src/loggers/groot2_publisher.cpp", "#include <zmq.hpp>\n")
    workspace.site("behaviortree_cpp/groot")
    workspace.build()
    [program] = workspace.cache.glob("nodes/*/groot.jspi.wasm")
    assert b"Groot2 cannot connect" in program.read_bytes()
