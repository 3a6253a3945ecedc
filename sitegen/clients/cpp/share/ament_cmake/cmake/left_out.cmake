# Functions that only affect colcon, installations, tests, linters or RViz do nothing.
include_guard(GLOBAL)
foreach(command
  ament_add_default_options ament_environment_hooks ament_export_link_flags
  ament_export_development_version_if_higher_than_manifest ament_generate_environment
  ament_generate_package_environment register_rviz_ogre_media_exports
  # tests
  add_launch_test add_ros_isolated_launch_test add_ros_test
  ament_add_gmock ament_add_gmock_executable ament_add_gmock_test
  ament_add_google_benchmark ament_add_google_benchmark_executable ament_add_google_benchmark_test
  ament_add_gtest ament_add_gtest_executable ament_add_gtest_test
  ament_add_pytest_test ament_add_nose_test ament_add_ros_isolated_gmock
  ament_add_ros_isolated_gtest ament_add_ros_isolated_pytest_test ament_add_test
  ament_add_test_label ament_find_gmock ament_find_gtest ament_lint_auto_find_test_dependencies
  # linters
  ament_clang_format ament_clang_tidy ament_copyright ament_cppcheck ament_cpplint ament_flake8
  ament_lint_cmake ament_mypy ament_pclint ament_pep257 ament_pycodestyle ament_pyflakes
  ament_uncrustify ament_xmllint)
  cmake_language(EVAL CODE "macro(${command})\nendmacro()")
endforeach()
