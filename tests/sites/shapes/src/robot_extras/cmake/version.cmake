function(robot_extras_version target)
  target_compile_definitions(${target} PRIVATE ROBOT_VERSION="9-$ENV{ROS_DISTRO}")
endfunction()
