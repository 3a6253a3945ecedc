#pragma once

#include <memory>
#include <vector>

#include "rclcpp/clock.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/subscription.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

namespace rclcpp
{

class Node;

/// Gives ROS clocks the time of /clock while the parameter use_sim_time of its node is true.
class TimeSource : private detail::SimulatedTime
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimeSource)
  RCLCPP_DISABLE_COPY(TimeSource)

  explicit TimeSource(
    std::shared_ptr<Node> node, const QoS & qos = ClockQoS(), bool use_clock_thread = true);
  explicit TimeSource(const QoS & qos = ClockQoS(), bool use_clock_thread = true);
  ~TimeSource();

  void attachNode(std::shared_ptr<Node> node);
  void attachNode(
    node_interfaces::NodeBaseInterface::SharedPtr base,
    node_interfaces::NodeParametersInterface::SharedPtr parameters);
  void detachNode();
  void attachClock(Clock::SharedPtr clock);
  void detachClock(Clock::SharedPtr clock);
  bool get_use_clock_thread() const {return false;}

private:
  using ClockMessage = rosgraph_msgs::msg::Clock;

  void set_active(bool active);
  /// Clocks call it whenever they are read, so that /clock needs no executor and advances while a callback
  /// sleeps.
  void take() override;

  QoS qos_;
  bool active_ = false;
  std::int64_t last_ = 0;
  node_interfaces::NodeBaseInterface::SharedPtr base_;
  std::vector<Clock::SharedPtr> clocks_;
  std::shared_ptr<Subscription<ClockMessage>> subscription_;
  node_interfaces::PostSetParametersCallbackHandle::SharedPtr on_set_;
};

}  // namespace rclcpp
