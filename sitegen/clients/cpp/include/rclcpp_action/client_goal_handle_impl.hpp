// Exists because upstream has this header.
#pragma once

#include "rclcpp_action/client_goal_handle.hpp"
