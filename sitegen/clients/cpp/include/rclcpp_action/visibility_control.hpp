#pragma once

// Programs are linked statically, so all symbols are visible.
#define RCLCPP_ACTION_EXPORT
#define RCLCPP_ACTION_IMPORT
#define RCLCPP_ACTION_PUBLIC
#define RCLCPP_ACTION_LOCAL
