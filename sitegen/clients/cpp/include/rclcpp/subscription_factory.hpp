// Without the factory of upstream: a node creates its subscriptions itself.
#pragma once

#include "rclcpp/subscription.hpp"
