#pragma once

#include <utility>

#include "rclcpp/macros.hpp"

namespace rclcpp
{

/// A flag to set, check and clear.
class Event
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Event)
  RCLCPP_DISABLE_COPY(Event)

  Event() = default;
  virtual ~Event() = default;

  /// Return the previous value.
  virtual bool set() {return std::exchange(state_, true);}
  virtual bool check() {return state_;}
  virtual bool check_and_clear() {return std::exchange(state_, false);}

private:
  bool state_ = false;
};

}  // namespace rclcpp
