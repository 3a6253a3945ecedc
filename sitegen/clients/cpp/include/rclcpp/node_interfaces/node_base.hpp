// Without the class of upstream: a node creates its interfaces itself.
#pragma once

#include "rclcpp/node_interfaces/node_base_interface.hpp"
