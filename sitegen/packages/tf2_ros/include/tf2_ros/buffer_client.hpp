#pragma once

#include <string>

#include "rclcpp_action/rclcpp_action.hpp"
#include "tf2/exceptions.hpp"
#include "tf2/time.hpp"
#include "tf2_msgs/action/lookup_transform.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2_ros
{

class LookupTransformGoalException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
class GoalRejectedException : public LookupTransformGoalException
{
public:
  using LookupTransformGoalException::LookupTransformGoalException;
};
class GoalAbortedException : public LookupTransformGoalException
{
public:
  using LookupTransformGoalException::LookupTransformGoalException;
};
class GoalCanceledException : public LookupTransformGoalException
{
public:
  using LookupTransformGoalException::LookupTransformGoalException;
};
class UnexpectedResultCodeException : public LookupTransformGoalException
{
public:
  using LookupTransformGoalException::LookupTransformGoalException;
};

/// Requests transforms from a BufferServer. Another thread must spin its node.
class BufferClient : public BufferInterface
{
public:
  using LookupTransformAction = tf2_msgs::action::LookupTransform;

  /// `node` is a pointer to a node; `ns` is the name of the action. The client waits
  /// `timeout_padding` longer than the timeout that it requests from the server.
  template<typename NodePtr>
  BufferClient(
    NodePtr node, const std::string ns, const double & check_frequency = 10.0,
    const tf2::Duration & timeout_padding = tf2::durationFromSec(2.0))
  : client_(rclcpp_action::create_client<LookupTransformAction>(node, ns)),
    check_period_(tf2::durationFromSec(1.0 / check_frequency)), timeout_padding_(timeout_padding) {}

  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame,
    const tf2::TimePoint & time,
    const tf2::Duration timeout = tf2::durationFromSec(0.0)) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & source_frame, const tf2::TimePoint & source_time,
    const std::string & fixed_frame,
    const tf2::Duration timeout = tf2::durationFromSec(0.0)) const override;
  bool canTransform(
    const std::string & target_frame, const std::string & source_frame,
    const tf2::TimePoint & time, const tf2::Duration timeout = tf2::durationFromSec(0.0),
    std::string * error = nullptr) const override;
  bool canTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & source_frame, const tf2::TimePoint & source_time,
    const std::string & fixed_frame, const tf2::Duration timeout = tf2::durationFromSec(0.0),
    std::string * error = nullptr) const override;

  bool waitForServer(const tf2::Duration & timeout = tf2::durationFromSec(0))
  {
    return client_->wait_for_action_server(timeout);
  }

private:
  geometry_msgs::msg::TransformStamped ask(const LookupTransformAction::Goal & goal) const;

  rclcpp_action::Client<LookupTransformAction>::SharedPtr client_;
  tf2::Duration check_period_;
  tf2::Duration timeout_padding_;
};

}  // namespace tf2_ros
