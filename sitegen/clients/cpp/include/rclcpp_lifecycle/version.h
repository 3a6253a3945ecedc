// The version of rclcpp_lifecycle in Kilted, whose API this is.
#pragma once

#define RCLCPP_LIFECYCLE_VERSION_MAJOR (29)
#define RCLCPP_LIFECYCLE_VERSION_MINOR (5)
#define RCLCPP_LIFECYCLE_VERSION_PATCH (0)
#define RCLCPP_LIFECYCLE_VERSION_STR "29.5.0"
#define RCLCPP_LIFECYCLE_VERSION_GTE(major, minor, patch) \
  ((29 > (major)) || (29 == (major) && \
  (5 > (minor) || (5 == (minor) && 0 >= (patch)))))
