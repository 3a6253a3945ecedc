// Without the factory of upstream: a node creates its publishers itself.
#pragma once

#include "rclcpp/publisher.hpp"
