"""Each action and each substitution of launch and launch_ros, in all three formats.

What upstream exposes was read from launch 3.7.1 and launch_ros 0.28.0, with the loops and joined
strings of launch 3.8. Each row works, is noted with a line of its own, or is refused as upstream
refuses it; nothing is dropped without a word.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml

from sitegen import workspace
from sitegen.errors import Problems
from sitegen.launch import launched

CONTAINER = """
<node_container pkg='rclcpp_components' exec='component_container' name='c' namespace=''>
  <composable_node pkg='mine' plugin='P' name='n' namespace=''>
    <param name='a' value='1'/><remap from='a' to='b'/>
    <extra_arg name='use_intra_process_comms' value='true'/>
  </composable_node>
</node_container>"""
NODE = """
<node pkg='mine' exec='x' name='n' exec_name='e' namespace='s' args='1' output='screen'
    ros_args='--log-level info' respawn_delay='1'>
  <param name='a' value='1'/><remap from='a' to='b'/><env name='A' value='b'/>
</node>"""
# The file of upstream, the action in XML, and the beginning of what is said about it.
ACTIONS = [
    ("append_environment_variable", "<append_env name='A' value='b' prepend='true'/>", ""),
    ("declare_launch_argument", "<arg name='a' default='b' description='c'/>", ""),
    ("declare_launch_argument", "<arg name='a' default='b'><choice value='b'/></arg>", ""),
    ("declare_boolean_launch_argument", "<bool_arg name='a' default='true'/>", ""),
    ("execute_process", "<executable cmd='ls' output='screen'/>", "executable: skipped: system"),
    (
        "execute_process",
        "<executable cmd='ros2 run mine x'><env name='A' value='b'/></executable>",
        "",
    ),
    ("for_loop", "<for len='2' name='i'><let name='a' value='$(index i)'/></for>", ""),
    ("for_loop", "<for_each values='{a: 1}'><let name='a' value='$(for-var a)'/></for_each>", ""),
    (
        "group_action",
        "<group scoped='true' forwarding='true'><keep name='a' value='b'/></group>",
        "",
    ),
    (
        "include_launch_description",
        "<include file='other.launch.xml'><arg name='a' value='b'/></include>",
        "",
    ),
    (
        "include_launch_description",
        "<include file='other.launch.xml'><let name='a' value='b'/></include>",
        "",
    ),
    ("log", "<log message='a' level='INFO'/>", ""),
    *(
        ("log", f"<log_{level} message='a'/>", "")
        for level in ("debug", "error", "info", "warning")
    ),
    ("replace_environment_variables", "<rep_env><env name='A' value='b'/></rep_env>", ""),
    ("reset_environment", "<reset_env/>", ""),
    ("reset_launch_configurations", "<reset><keep name='a' value='b'/></reset>", ""),
    ("set_environment_variable", "<set_env name='A' value='b'/>", ""),
    ("set_launch_configuration", "<let name='a' value='b'/>", ""),
    ("shutdown_action", "<shutdown reason='a'/>", "shutdown: skipped: the nodes of the page"),
    ("shutdown_action", "<timer period='1'><shutdown reason='a'/></timer>", ""),
    ("timer_action", "<timer period='1.5'><let name='a' value='b'/></timer>", ""),
    ("timer_action", "<timer period='soon'/>", "timer: 'soon' is not of type 'float'"),
    ("unset_environment_variable", "<unset_env name='A'/>", ""),
    (
        "composable_node_container",
        CONTAINER,
        "",
    ),
    ("lifecycle_node", "<lifecycle_node pkg='mine' exec='x' name='n' namespace=''/>", ""),
    (
        "lifecycle_node",
        "<lifecycle_node pkg='mine' exec='x' name='n' namespace='' autostart='true'/>",
        "",
    ),
    (
        "load_composable_nodes",
        "<load_composable_node target='/c'/>",
        "load_composable_node: no component container",
    ),
    (
        "node",
        NODE,
        "",
    ),
    (
        "node",
        "<node pkg='mine' exec='x' respawn='true' respawn_delay='2' respawn_max_retries='3'/>",
        "",
    ),
    (
        "node",
        "<node pkg='mine' exec='x' respawn='true' respawn_delay='-1'/>",
        "node: 'respawn_delay' is not a non-negative number",
    ),
    ("node", "<node pkg='mine' exec='x' launch-prefix='gdb'/>", "node: 'launch-prefix' is ignored"),
    ("node", "<node pkg='mine' exec='x' cwd='node'/>", "node: 'cwd' is ignored"),
    ("node", "<node pkg='mine' exec='x' on_exit='shutdown'/>", ""),
    ("node", "<node pkg='mine' exec='x' on_exit='restart'/>", "node: 'on_exit' is 'shutdown' or"),
    ("push_ros_namespace", "<push_ros_namespace namespace='a'/>", ""),
    ("push_ros_namespace", "<push-ros-namespace namespace='a'/>", ""),
    (
        "ros_timer",
        "<ros_timer period='1.5'><let name='a' value='b'/></ros_timer>",
        "",
    ),
    ("set_parameter", "<set_parameter name='a' value='1'/>", ""),
    ("set_parameters_from_file", "<set_parameters_from_file filename='p.yaml'/>", ""),
    ("set_remap", "<set_remap from='a' to='b'/>", ""),
    ("set_ros_log_dir", "<set_ros_log_dir new_log_dir='a'/>", ""),
    ("set_use_sim_time", "<set_use_sim_time value='true'/>", ""),
]
# The file of upstream, the substitution, and its value here.
SUBSTITUTIONS = [
    ("anon_name", "$(anon a)", "a_ca978112"),
    ("boolean_substitution", "$(not true)", "false"),
    ("boolean_substitution", "$(and true false)", "false"),
    ("boolean_substitution", "$(or true false)", "true"),
    ("boolean_substitution", "$(any false true)", "true"),
    ("boolean_substitution", "$(all true false)", "false"),
    ("command", "$(command 'cat $(dirname)/words')", "two words"),
    ("environment_variable", "$(env NOWHERE 'a b')", "a b"),
    ("equals_substitution", "$(equals 1 1.0)", "true"),
    ("file_content", "$(file-content $(dirname)/words)", "two words"),
    ("find_executable", "$(find-exec ls)", "ls"),
    ("for_loop_var", "$(for-var a b)", "b"),
    ("if_else_substitution", "$(if true a b)", "a"),
    ("launch_configuration", "$(var a b)", "b"),
    ("launch_log_dir", "$(log_dir)", "/root/.ros/log"),
    ("launch_log_dir", "$(launch_log_dir)", "/root/.ros/log"),
    ("not_equals_substitution", "$(not-equals 1 2)", "true"),
    ("python_expression", "$(eval '1 + 1')", "2"),
    ("string_join_substitution", "$(string-join - a b)", "a-b"),
    ("this_launch_file", "$(filename)", "{root}/x.launch.{kind}"),
    ("this_launch_file_dir", "$(dirname)", "{root}"),
    ("executable_in_package", "$(exec-in-pkg x mine)", "{root}/src/mine/lib/mine/x"),
    ("find_package", "$(find-pkg-prefix mine)", "{root}/src/mine"),
    ("find_package", "$(find-pkg-share mine)", "{root}/src/mine"),
    ("parameter", "$(param a b)", "b"),
]
# The module and the name of upstream, an action that uses it, and what is said about it.
PYTHON = [
    (
        "launch.actions",
        "AppendEnvironmentVariable",
        "{}('A', 'b', prepend=True, separator=',')",
        "",
    ),
    ("launch.actions", "DeclareBooleanLaunchArgument", "{}('a', default_value=True)", ""),
    ("launch.actions", "DeclareLaunchArgument", "{}('a', default_value='b', choices=['b'])", ""),
    ("launch.actions", "EmitEvent", "{}(event=Shutdown())", "shutdown: skipped: the nodes of"),
    ("launch.actions", "EmitEvent", "{}(event=None)", "event: skipped: this event is"),
    ("launch.actions", "ExecuteLocal", "{}(process_description=None)", "executable: skipped"),
    ("launch.actions", "ExecuteProcess", "{}(cmd=['ls'])", "executable: skipped: system"),
    ("launch.actions", "ForEach", "{}('{{a: 1}}', function=lambda a: [])", ""),
    ("launch.actions", "ForLoop", "{}('2', function=lambda i: [])", ""),
    ("launch.actions", "GroupAction", "{}([], scoped=True, forwarding=False)", ""),
    ("launch.actions", "IncludeLaunchDescription", "{}('other.launch.xml')", ""),
    ("launch.actions", "LogInfo", "{}(msg='a')", ""),
    ("launch.actions", "OpaqueCoroutine", "{}(coroutine=None)", "OpaqueCoroutine: this action is"),
    ("launch.actions", "OpaqueFunction", "{}(function=lambda context: [])", ""),
    ("launch.actions", "PopEnvironment", "GroupAction([PushEnvironment(), {}()])", ""),
    ("launch.actions", "PopEnvironment", "{}()", "pop_env: nothing was pushed before"),
    ("launch.actions", "PushLaunchConfigurations", "{}()", ""),
    (
        "launch.actions",
        "PopLaunchConfigurations",
        "GroupAction([PushLaunchConfigurations(), {}()], scoped=False)",
        "",
    ),
    ("launch.actions", "RegisterEventHandler", "{}(OnShutdown(on_shutdown=[]))", ""),
    (
        "launch.actions",
        "RegisterEventHandler",
        "{}(EventHandler(matcher=None))",
        "event_handler: skipped: this event",
    ),
    ("launch.actions", "ReplaceEnvironmentVariables", "{}({{'A': 'b'}})", ""),
    ("launch.actions", "ResetEnvironment", "{}()", ""),
    ("launch.actions", "ResetLaunchConfigurations", "{}({{'a': 'b'}})", ""),
    ("launch.actions", "SetEnvironmentVariable", "{}('A', 'b')", ""),
    ("launch.actions", "SetLaunchConfiguration", "{}('a', 'b')", ""),
    ("launch.actions", "Shutdown", "{}(reason='a')", "shutdown: skipped: the nodes of"),
    ("launch.actions", "TimerAction", "{}(period=1.5, actions=[])", ""),
    ("launch.actions", "UnregisterEventHandler", "{}(None)", "event_handler: skipped"),
    ("launch.actions", "UnsetEnvironmentVariable", "{}('A')", ""),
    ("launch.actions", "UnsetLaunchConfiguration", "{}('a')", ""),
    ("launch.conditions", "IfCondition", "LogInfo(msg='a', condition={}('true'))", ""),
    (
        "launch.conditions",
        "UnlessCondition",
        "ResetEnvironment(condition={}('x'))",
        "reset_env: 'x'",
    ),
    (
        "launch.conditions",
        "LaunchConfigurationEquals",
        "GroupAction([SetLaunchConfiguration('a', 'b'), ResetEnvironment(condition={}('a', 'b'))])",
        "",
    ),
    (
        "launch.event_handlers",
        "OnProcessStart",
        "RegisterEventHandler({}(target_action=None, on_start=[ResetEnvironment()]))",
        "",
    ),
    ("launch.event_handlers", "OnProcessExit", "RegisterEventHandler({}(on_exit=[]))", ""),
    ("launch.event_handlers", "OnProcessExit", "RegisterEventHandler({}())", "launch: TypeError"),
    (
        "launch.event_handlers",
        "OnProcessExit",
        "RegisterEventHandler({}(on_exit=lambda event, context: []))",
        "event_handler: skipped: the functions of",
    ),
    (
        "launch.event_handlers",
        "OnExecutionComplete",
        "RegisterEventHandler({}(on_completion=[]))",
        "",
    ),
    ("launch.event_handlers", "OnProcessIO", "RegisterEventHandler({}())", "event_handler: skip"),
    (
        "launch_ros.actions",
        "LifecycleTransition",
        "{}(lifecycle_node_names=['a'], transition_ids=[1])",
        "lifecycle_transition: no lifecycle node '/a' in this launch file",
    ),
    ("launch_ros.actions", "PushRosNamespace", "{}('a')", ""),
    ("launch_ros.actions", "PushROSNamespace", "{}('a')", ""),
    ("launch_ros.actions", "ROSTimer", "{}(period=1, actions=[])", ""),
    ("launch_ros.actions", "SetParameter", "{}('a', [1, 2])", ""),
    ("launch_ros.actions", "SetParametersFromFile", "{}('p.yaml')", ""),
    ("launch_ros.actions", "SetRemap", "{}('a', 'b')", ""),
    ("launch_ros.actions", "SetROSLogDir", "{}('a')", ""),
    ("launch_ros.actions", "SetUseSimTime", "{}(True)", ""),
    (
        "launch_ros.events.lifecycle",
        "ChangeState",
        "EmitEvent(event={}(lifecycle_node_matcher=lambda node: True, transition_id=1))",
        "change_state: skipped: the functions of",
    ),
    (
        "launch_ros.event_handlers",
        "OnStateTransition",
        "RegisterEventHandler({}(goal_state='active', entities=[]))",
        "",
    ),
]
# Those whose parts are actions.
WITH_ACTIONS = ("for", "for_each", "group", "launch", "ros_timer", "timer")


@pytest.fixture
def root(root: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (root / "other.launch.xml").write_text("<launch/>")
    (root / "p.yaml").write_text("/**: {ros__parameters: {a: 1}}")
    (root / "words").write_text("two words")
    monkeypatch.chdir(root)
    return root


def in_yaml(element: ElementTree.Element) -> dict[str, object]:
    """Return an action of XML in the form of YAML."""
    parts: dict[str, object] = dict(element.attrib)
    for part in element:
        if element.tag in WITH_ACTIONS and part.tag != "keep":
            parts.setdefault("children", []).append({part.tag: in_yaml(part)})  # type: ignore[attr-defined]
        else:
            parts.setdefault(part.tag, []).append(in_yaml(part))  # type: ignore[attr-defined]
    return parts


def said(root: Path, file: Path) -> Iterator[str]:
    """Yield what is said about a launch file, without its name and the line."""
    problems, notes = Problems(root), Problems(root)
    launched(file, {}, workspace.scan(root), problems, notes)
    for line in [*problems.lines, *notes.lines]:
        assert line.startswith(f"{file.name}:"), line
        yield line.partition(": ")[2]


@pytest.mark.parametrize("kind", ["xml", "yaml"])
@pytest.mark.parametrize(("source", "action", "expected"), ACTIONS)
def test_actions(root: Path, source: str, action: str, expected: str, kind: str) -> None:
    file = root / f"x.launch.{kind}"
    if kind == "yaml":
        element = ElementTree.fromstring(action)
        file.write_text(yaml.safe_dump({"launch": [{element.tag: in_yaml(element)}]}))
    else:
        file.write_text(f"<launch>{action}</launch>")
    found = [*said(root, file)]
    assert len(found) == bool(expected), (source, found)
    assert "".join(found).startswith(expected)


@pytest.mark.parametrize("kind", ["xml", "yaml"])
@pytest.mark.parametrize(("source", "text", "expected"), SUBSTITUTIONS)
def test_substitutions(root: Path, source: str, text: str, expected: str, kind: str) -> None:
    file = root / f"x.launch.{kind}"
    node = {"pkg": "mine", "exec": "x", "env": [{"name": "V", "value": text}]}
    if kind == "yaml":
        file.write_text(yaml.safe_dump({"launch": [{"node": node}]}))
    else:
        file.write_text(
            f'<launch><node pkg="mine" exec="x"><env name="V" value="{text}"/></node></launch>'
        )
    problems = Problems(root)
    [found] = launched(file, {}, workspace.scan(root), problems).nodes
    assert problems.lines == [], source
    place = expected.format(root=root, kind=kind)
    assert found.environment["V"] == place.replace(f"{root}/src/mine", "/ros/share/mine")


@pytest.mark.parametrize(("module", "name", "use", "expected"), PYTHON)
def test_python(root: Path, module: str, name: str, use: str, expected: str) -> None:
    file = root / "x.launch.py"
    file.write_text(
        f"from launch import LaunchDescription\nfrom launch.actions import *\n"
        f"from launch.event_handlers import *\nfrom {module} import {name}\n"
        f"def generate_launch_description():\n    return LaunchDescription([{use.format(name)}])\n"
    )
    found = [*said(root, file)]
    assert len(found) == bool(expected), found
    assert "".join(found).startswith(expected)
