#pragma once

// Programs are linked statically, so all symbols are visible.
#define RCLCPP_COMPONENTS_EXPORT
#define RCLCPP_COMPONENTS_IMPORT
#define RCLCPP_COMPONENTS_PUBLIC
#define RCLCPP_COMPONENTS_LOCAL
