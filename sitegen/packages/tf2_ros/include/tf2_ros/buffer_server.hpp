#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "rclcpp/create_timer.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "tf2/buffer_core.hpp"
#include "tf2/time.hpp"
#include "tf2_msgs/action/lookup_transform.hpp"

namespace tf2_ros
{

/// Serves a BufferClient from its buffer: responds once the transform is available, or on timeout.
class BufferServer
{
public:
  using LookupTransformAction = tf2_msgs::action::LookupTransform;
  using GoalHandle = std::shared_ptr<rclcpp_action::ServerGoalHandle<LookupTransformAction>>;

  /// `node` is a pointer to a node; `ns` is the name of the action.
  template<typename NodePtr>
  BufferServer(
    const tf2::BufferCore & buffer, NodePtr node, const std::string & ns,
    const tf2::Duration & check_period = tf2::durationFromSec(0.01))
  : buffer_(buffer)
  {
    server_ = rclcpp_action::create_server<LookupTransformAction>(
      node, ns,
      [](const rclcpp_action::GoalUUID &, std::shared_ptr<const LookupTransformAction::Goal>) {
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [this](GoalHandle handle) {return cancel(handle);},
      [this](GoalHandle handle) {accept(handle);});
    timer_ = rclcpp::create_timer(
      node, node->get_clock(), rclcpp::Duration(check_period), [this]() {check();});
  }

private:
  struct Waiting
  {
    GoalHandle handle;
    tf2::TimePoint end;
  };

  rclcpp_action::CancelResponse cancel(const GoalHandle & handle);
  void accept(const GoalHandle & handle);
  void check();
  bool can_answer(const GoalHandle & handle) const;
  void answer(const GoalHandle & handle) const;

  const tf2::BufferCore & buffer_;
  std::mutex mutex_;
  std::list<Waiting> waiting_;
  rclcpp_action::Server<LookupTransformAction>::SharedPtr server_;
  rclcpp::TimerBase::SharedPtr timer_;
};

}  // namespace tf2_ros
