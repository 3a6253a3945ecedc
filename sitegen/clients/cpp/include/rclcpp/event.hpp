#pragma once

#include <utility>

#include "rclcpp/macros.hpp"

namespace rclcpp
{

/// A flag that somebody sets, and whoever looks may take down.
class Event
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Event)
  RCLCPP_DISABLE_COPY(Event)

  Event() = default;
  virtual ~Event() = default;

  /// Return what it was before.
  virtual bool set() {return std::exchange(state_, true);}
  virtual bool check() {return state_;}
  virtual bool check_and_clear() {return std::exchange(state_, false);}

private:
  bool state_ = false;
};

}  // namespace rclcpp
