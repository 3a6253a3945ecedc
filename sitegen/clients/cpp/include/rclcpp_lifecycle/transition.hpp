#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "rclcpp_lifecycle/state.hpp"

namespace rclcpp_lifecycle
{

class Transition
{
public:
  explicit Transition(
    std::uint8_t id, std::string label = "", State start = State(), State goal = State())
  : id_(id), label_(std::move(label)), start_(std::move(start)), goal_(std::move(goal)) {}

  std::uint8_t id() const {return id_;}
  std::string label() const {return label_;}
  State start_state() const {return start_;}
  State goal_state() const {return goal_;}

private:
  std::uint8_t id_;
  std::string label_;
  State start_;
  State goal_;
};

}  // namespace rclcpp_lifecycle
