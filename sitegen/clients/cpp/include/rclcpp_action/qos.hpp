#pragma once

#include "rclcpp/qos.hpp"
#include "rclcpp_action/visibility_control.hpp"

namespace rclcpp_action
{

/// The QoS of the topics on which servers publish the status of their goals.
class DefaultActionStatusQoS : public rclcpp::QoS
{
public:
  DefaultActionStatusQoS()
  : QoS(rclcpp::KeepLast(1))
  {
    reliable().transient_local();
  }
};

}  // namespace rclcpp_action
