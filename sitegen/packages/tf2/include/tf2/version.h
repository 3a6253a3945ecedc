// The version of tf2 in Kilted, whose API this is.
#pragma once

#define TF2_VERSION_MAJOR (0)
#define TF2_VERSION_MINOR (41)
#define TF2_VERSION_PATCH (0)
#define TF2_VERSION_STR "0.41.0"
#define TF2_VERSION_GTE(major, minor, patch) \
  ((0 > (major)) || (0 == (major) && \
  (41 > (minor) || (41 == (minor) && 0 >= (patch)))))
