// The version of pluginlib in Kilted, whose API this is.
#pragma once

#define PLUGINLIB_VERSION_MAJOR (5)
#define PLUGINLIB_VERSION_MINOR (6)
#define PLUGINLIB_VERSION_PATCH (0)
#define PLUGINLIB_VERSION_STR "5.6.0"
#define PLUGINLIB_VERSION_GTE(major, minor, patch) \
  ((5 > (major)) || (5 == (major) && \
  (6 > (minor) || (6 == (minor) && 0 >= (patch)))))
