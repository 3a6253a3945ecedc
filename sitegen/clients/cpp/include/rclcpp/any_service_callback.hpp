// Without the class of upstream: a service keeps its callback itself.
#pragma once

#include "rclcpp/service.hpp"
