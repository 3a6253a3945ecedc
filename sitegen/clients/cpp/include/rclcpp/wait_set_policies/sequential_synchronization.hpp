// Exists because upstream has this header.
#pragma once

#include "rclcpp/wait_set.hpp"
