// The predefined QoS profiles.
#ifndef RMW__QOS_PROFILES_H_
#define RMW__QOS_PROFILES_H_

#include "rmw/types.h"

#define RMW_DURATION_INFINITE {9223372036LL, 854775807LL}
#define RMW_DURATION_UNSPECIFIED {0LL, 0LL}
#define RMW_QOS_DEADLINE_DEFAULT RMW_DURATION_UNSPECIFIED
#define RMW_QOS_LIFESPAN_DEFAULT RMW_DURATION_UNSPECIFIED
#define RMW_QOS_LIVELINESS_LEASE_DURATION_DEFAULT RMW_DURATION_UNSPECIFIED

#define ROS_PROFILE(history, depth, reliability, durability, liveliness) \
  { \
    RMW_QOS_POLICY_HISTORY_ ## history, depth, RMW_QOS_POLICY_RELIABILITY_ ## reliability, \
    RMW_QOS_POLICY_DURABILITY_ ## durability, RMW_QOS_DEADLINE_DEFAULT, \
    RMW_QOS_LIFESPAN_DEFAULT, RMW_QOS_POLICY_LIVELINESS_ ## liveliness, \
    RMW_QOS_LIVELINESS_LEASE_DURATION_DEFAULT, false \
  }

static const rmw_qos_profile_t rmw_qos_profile_default =
  ROS_PROFILE(KEEP_LAST, 10, RELIABLE, VOLATILE, SYSTEM_DEFAULT);
static const rmw_qos_profile_t rmw_qos_profile_sensor_data =
  ROS_PROFILE(KEEP_LAST, 5, BEST_EFFORT, VOLATILE, SYSTEM_DEFAULT);
static const rmw_qos_profile_t rmw_qos_profile_services_default =
  ROS_PROFILE(KEEP_LAST, 10, RELIABLE, VOLATILE, SYSTEM_DEFAULT);
static const rmw_qos_profile_t rmw_qos_profile_parameters =
  ROS_PROFILE(KEEP_LAST, 1000, RELIABLE, VOLATILE, SYSTEM_DEFAULT);
static const rmw_qos_profile_t rmw_qos_profile_parameter_events =
  ROS_PROFILE(KEEP_LAST, 1000, RELIABLE, VOLATILE, SYSTEM_DEFAULT);
static const rmw_qos_profile_t rmw_qos_profile_rosout_default =
  ROS_PROFILE(KEEP_LAST, 1000, RELIABLE, TRANSIENT_LOCAL, SYSTEM_DEFAULT);
static const rmw_qos_profile_t rmw_qos_profile_system_default =
  ROS_PROFILE(SYSTEM_DEFAULT, 0, SYSTEM_DEFAULT, SYSTEM_DEFAULT, SYSTEM_DEFAULT);
static const rmw_qos_profile_t rmw_qos_profile_best_available =
  ROS_PROFILE(KEEP_LAST, 10, BEST_AVAILABLE, BEST_AVAILABLE, BEST_AVAILABLE);

#undef ROS_PROFILE

#endif  /* RMW__QOS_PROFILES_H_ */
