// Exists because upstream has this header.
#pragma once

#include "rclcpp_lifecycle/lifecycle_node.hpp"
