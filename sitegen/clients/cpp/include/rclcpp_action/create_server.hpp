#pragma once

#include "rclcpp_action/server.hpp"
