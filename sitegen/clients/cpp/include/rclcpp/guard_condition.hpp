#pragma once

#include <cstddef>
#include <functional>

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
  void trigger();
  /// Call `callback` with the number of triggers, from now on with each; null stops that.
  void set_on_trigger_callback(std::function<void (std::size_t)> callback);

  bool is_triggered() const {return triggers_ > 0;}
  /// Whether it was triggered since it was asked the last time.
  bool take();

private:
  Context::SharedPtr context_;
  std::size_t triggers_ = 0;
  std::function<void (std::size_t)> callback_;
};

}  // namespace rclcpp
