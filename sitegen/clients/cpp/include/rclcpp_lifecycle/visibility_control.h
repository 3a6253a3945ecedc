#pragma once

// Programs are linked statically, so all symbols are visible.
#define RCLCPP_LIFECYCLE_EXPORT
#define RCLCPP_LIFECYCLE_IMPORT
#define RCLCPP_LIFECYCLE_PUBLIC
#define RCLCPP_LIFECYCLE_LOCAL
