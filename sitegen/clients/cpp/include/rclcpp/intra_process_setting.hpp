#pragma once

#include "rclcpp/publisher.hpp"
