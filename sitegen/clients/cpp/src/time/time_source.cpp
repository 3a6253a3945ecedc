#include "rclcpp/time_source.hpp"

#include <algorithm>
#include <utility>

#include "rclcpp/node.hpp"

namespace rclcpp
{

TimeSource::TimeSource(std::shared_ptr<Node> node, const QoS & qos, bool)
: TimeSource(qos)
{
  attachNode(std::move(node));
}

TimeSource::TimeSource(const QoS & qos, bool)
: qos_(qos)
{
}

TimeSource::~TimeSource() {detachNode();}

void TimeSource::attachNode(std::shared_ptr<Node> node)
{
  attachNode(node->get_node_base_interface(), node->get_node_parameters_interface());
}

void TimeSource::attachNode(
  node_interfaces::NodeBaseInterface::SharedPtr base,
  node_interfaces::NodeParametersInterface::SharedPtr parameters)
{
  base_ = std::move(base);
  if (!parameters->has_parameter("use_sim_time")) {
    parameters->declare_parameter("use_sim_time", ParameterValue(false));
  }
  set_active(parameters->get_parameter("use_sim_time").as_bool());
  on_set_ = parameters->add_post_set_parameters_callback(
    [this](const std::vector<Parameter> & changed) {
      for (const auto & parameter : changed) {
        if (parameter.get_name() == "use_sim_time") {set_active(parameter.as_bool());}
      }
    });
}

void TimeSource::detachNode()
{
  set_active(false);
  on_set_.reset();
  base_.reset();
}

void TimeSource::attachClock(Clock::SharedPtr clock)
{
  if (clock->get_clock_type() != RCL_ROS_TIME) {
    throw std::invalid_argument("Cannot attach clock to a time source that's not a ROS clock");
  }
  clocks_.push_back(clock);
  if (active_) {clock->set_source(this, last_);}
}

void TimeSource::detachClock(Clock::SharedPtr clock)
{
  clocks_.erase(std::remove(clocks_.begin(), clocks_.end(), clock), clocks_.end());
  clock->set_source(nullptr, 0);
}

void TimeSource::set_active(bool active)
{
  if (active == active_) {return;}
  active_ = active;
  if (active) {
    subscription_ = std::make_shared<Subscription<ClockMessage>>(
      *base_, "/clock", qos_, [this](const ClockMessage & message) {
        last_ = Time(message.clock).nanoseconds();
        for (const auto & clock : clocks_) {clock->set_ros_time(last_);}
      });
  }
  for (const auto & clock : clocks_) {clock->set_source(active ? this : nullptr, last_);}
  if (!active) {subscription_.reset();}
}

void TimeSource::take()
{
  while (subscription_ && subscription_->execute_one()) {}
}

}  // namespace rclcpp
