#pragma once

// Programs are linked statically, so all symbols are visible.
#define RCLCPP_EXPORT
#define RCLCPP_IMPORT
#define RCLCPP_PUBLIC
#define RCLCPP_LOCAL
