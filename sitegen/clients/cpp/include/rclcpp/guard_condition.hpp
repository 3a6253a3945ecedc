#pragma once

#include <cstddef>
#include <functional>

#include "rcl/wait.h"
#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

/// Ends a wait when it is triggered, from a callback or another thread.
class GuardCondition
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GuardCondition)
  RCLCPP_DISABLE_COPY(GuardCondition)

  explicit GuardCondition(
    const Context::SharedPtr & context = contexts::get_global_default_context());

  Context::SharedPtr get_context() const {return context_;}
  rcl_guard_condition_t & get_rcl_guard_condition() {return handle_;}
  const rcl_guard_condition_t & get_rcl_guard_condition() const {return handle_;}
  /// Add the guard condition to a Waitable.
  void add_to_wait_set(rcl_wait_set_t & wait_set)
  {
    rcl_wait_set_add_guard_condition(&wait_set, &handle_, nullptr);
  }
  void add_to_wait_set(rcl_wait_set_t * wait_set) {add_to_wait_set(*wait_set);}
  void trigger();
  /// Call `callback` with the number of triggers, from now on with each; null stops that.
  void set_on_trigger_callback(std::function<void (std::size_t)> callback);

  bool is_triggered() const {return triggers_ > 0;}
  /// Whether it has been triggered since the last call.
  bool take();

private:
  rcl_guard_condition_t handle_{this};
  Context::SharedPtr context_;
  std::size_t triggers_ = 0;
  std::function<void (std::size_t)> callback_;
};

}  // namespace rclcpp
