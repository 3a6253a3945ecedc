/* What a wait set tells of those that it waits for: in C++, as the programs that look at it are. */
#ifndef RCL__WAIT_H_
#define RCL__WAIT_H_

#include <stddef.h>

#include "rcl/types.h"

#ifdef __cplusplus

#include <vector>

namespace rclcpp {class GuardCondition;}

/// A guard condition.
struct rcl_guard_condition_t
{
  rclcpp::GuardCondition * impl;
};

/// In the order in which they were added; entities that are not ready are null.
struct rcl_wait_set_t
{
  std::vector<const void *> subscriptions;
  std::vector<const void *> guard_conditions;
  std::vector<const void *> timers;
  std::vector<const void *> clients;
  std::vector<const void *> services;
  std::size_t size_of_subscriptions = 0;
  std::size_t size_of_guard_conditions = 0;
  std::size_t size_of_timers = 0;
  std::size_t size_of_clients = 0;
  std::size_t size_of_services = 0;
};

inline rcl_ret_t rcl_wait_set_add_guard_condition(
  rcl_wait_set_t * wait_set, const rcl_guard_condition_t * guard_condition, std::size_t * index)
{
  if (!wait_set || !guard_condition) {return RCL_RET_INVALID_ARGUMENT;}
  wait_set->guard_conditions.push_back(guard_condition);
  const std::size_t last = wait_set->size_of_guard_conditions++;
  if (index) {*index = last;}
  return RCL_RET_OK;
}

#endif

#endif  /* RCL__WAIT_H_ */
