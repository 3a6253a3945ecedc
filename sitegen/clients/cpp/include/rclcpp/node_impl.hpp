// Exists because upstream has this header.
#pragma once

#include "rclcpp/node.hpp"
