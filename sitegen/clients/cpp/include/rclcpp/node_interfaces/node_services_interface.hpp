#pragma once

#include "rclcpp/node_interfaces/node_parts.hpp"
