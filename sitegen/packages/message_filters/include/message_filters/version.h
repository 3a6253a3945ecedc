// The version of message_filters in Kilted, whose API this is.
#pragma once

#define MESSAGE_FILTERS_VERSION_MAJOR (7)
#define MESSAGE_FILTERS_VERSION_MINOR (1)
#define MESSAGE_FILTERS_VERSION_PATCH (0)
#define MESSAGE_FILTERS_VERSION_STR "7.1.0"
#define MESSAGE_FILTERS_VERSION_GTE(major, minor, patch) \
  ((7 > (major)) || (7 == (major) && \
  (1 > (minor) || (1 == (minor) && 0 >= (patch)))))
