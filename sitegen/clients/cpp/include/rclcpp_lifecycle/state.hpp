#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "lifecycle_msgs/msg/state.hpp"

namespace rclcpp_lifecycle
{

class State
{
public:
  State() = default;
  State(std::uint8_t id, std::string label)
  : id_(id), label_(std::move(label)) {}

  std::uint8_t id() const {return id_;}
  std::string label() const {return label_;}

private:
  std::uint8_t id_ = lifecycle_msgs::msg::State::PRIMARY_STATE_UNKNOWN;
  std::string label_ = "unknown";
};

}  // namespace rclcpp_lifecycle
