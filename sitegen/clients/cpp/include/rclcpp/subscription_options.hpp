#pragma once

#include "rclcpp/subscription.hpp"
