// The version of ament_index_cpp in Kilted, whose API this is.
#pragma once

#define AMENT_INDEX_CPP_VERSION_MAJOR (1)
#define AMENT_INDEX_CPP_VERSION_MINOR (11)
#define AMENT_INDEX_CPP_VERSION_PATCH (0)
#define AMENT_INDEX_CPP_VERSION_STR "1.11.0"
#define AMENT_INDEX_CPP_VERSION_GTE(major, minor, patch) \
  ((1 > (major)) || (1 == (major) && \
  (11 > (minor) || (11 == (minor) && 0 >= (patch)))))
