#include "rclcpp/waitable.hpp"

#include <utility>

#include "rclcpp/guard_condition.hpp"

namespace rclcpp
{

bool Waitable::exchange_in_use_by_wait_set_state(bool in_use)
{
  return std::exchange(in_use_by_wait_set_, in_use);
}

bool Waitable::look()
{
  rcl_wait_set_t waits_for;
  add_to_wait_set(waits_for);
  for (auto & one : waits_for.guard_conditions) {
    const auto * guard_condition = static_cast<const rcl_guard_condition_t *>(one);
    if (guard_condition && !guard_condition->impl->take()) {one = nullptr;}
  }
  return is_ready(waits_for);
}

bool Waitable::execute_one()
{
  if (!look()) {return false;}
  const std::shared_ptr<void> data = take_data();
  execute(data);
  return true;
}

}  // namespace rclcpp
