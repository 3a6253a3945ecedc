#pragma once

#include <array>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "action_msgs/msg/goal_info.hpp"
#include "action_msgs/msg/goal_status.hpp"

namespace rclcpp_action
{

using GoalUUID = std::array<std::uint8_t, 16>;
using GoalStatus = action_msgs::msg::GoalStatus;
using GoalInfo = action_msgs::msg::GoalInfo;

std::string to_string(const GoalUUID & goal_id);

/// Return a unique id.
GoalUUID make_goal_id();

}  // namespace rclcpp_action

namespace std
{

template<>
struct less<rclcpp_action::GoalUUID>
{
  bool operator()(
    const rclcpp_action::GoalUUID & left, const rclcpp_action::GoalUUID & right) const
  {
    return left < right;
  }
};

template<>
struct hash<rclcpp_action::GoalUUID>
{
  std::size_t operator()(const rclcpp_action::GoalUUID & id) const noexcept
  {
    std::size_t result = 0;
    for (const auto byte : id) {result = result * 31 + byte;}
    return result;
  }
};

}  // namespace std
