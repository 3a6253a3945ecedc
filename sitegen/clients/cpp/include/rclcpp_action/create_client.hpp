#pragma once

#include "rclcpp_action/client.hpp"
