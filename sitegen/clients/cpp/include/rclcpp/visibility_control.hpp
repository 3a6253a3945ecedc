#pragma once

// Programs of a page are linked as a whole: everything is visible to everything.
#define RCLCPP_EXPORT
#define RCLCPP_IMPORT
#define RCLCPP_PUBLIC
#define RCLCPP_LOCAL
