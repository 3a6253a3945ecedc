#include "rclcpp_action/server.hpp"

#include <unistd.h>

#include <cstdio>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp_action
{

std::string to_string(const GoalUUID & goal_id)
{
  std::string text;
  for (const auto byte : goal_id) {
    char digits[3];
    std::snprintf(digits, sizeof(digits), "%02x", byte);
    text += digits;
  }
  return text;
}

GoalUUID make_goal_id()
{
  GoalUUID id;
  if (getentropy(id.data(), id.size()) != 0) {
    throw std::runtime_error("failed to generate a random goal ID");
  }
  return id;
}

void ServerGoalHandleBase::change(std::int8_t status, const char * event)
{
  static const char * const kNames[] = {
    "UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED"};
  const bool executing = status_ == GoalStatus::STATUS_EXECUTING;
  const bool accepted = status_ == GoalStatus::STATUS_ACCEPTED;
  bool due = false;
  switch (status) {
    case GoalStatus::STATUS_EXECUTING: due = accepted; break;
    case GoalStatus::STATUS_CANCELING: due = accepted || executing; break;
    case GoalStatus::STATUS_CANCELED: due = is_canceling(); break;
    default: due = executing || is_canceling();
  }
  if (!due) {
    throw rclcpp::exceptions::RCLError(
            std::string("goal_handle attempted invalid transition from state ") +
            kNames[status_] + " with event " + event);
  }
  status_ = status;
}

ServerBase::ServerBase(
  rclcpp::node_interfaces::NodeBaseInterface & node, const std::string & name,
  const rcl_action_server_options_t & options, const rclcpp::CallbackGroup::SharedPtr & group)
: clock_(RCL_ROS_TIME), result_timeout_(options.result_timeout.nanoseconds),
  cancel_service_(
    std::make_shared<rclcpp::Service<CancelGoal>>(
      node, name + "/_action/cancel_goal", rclcpp::QoS(10),
      [this](CancelGoal::Request::SharedPtr request, CancelGoal::Response::SharedPtr response) {
        cancel(*request, *response);
      })),
  status_publisher_(
    std::make_shared<rclcpp::Publisher<action_msgs::msg::GoalStatusArray>>(
      node, name + "/_action/status", rclcpp::QoS(1).transient_local()))
{
  node.add(rclcpp::detail::ExecutableKind::kService, cancel_service_, group);
}

void ServerBase::publish_status()
{
  action_msgs::msg::GoalStatusArray message;
  for (const auto & [id, entry] : entries_) {
    GoalStatus status;
    status.goal_info.goal_id.uuid = id;
    status.goal_info.stamp = entry.stamp;
    status.status = entry.status;
    message.status_list.push_back(status);
  }
  status_publisher_->publish(message);
}

void ServerBase::forget_old()
{
  const std::int64_t now = clock_.now().nanoseconds();
  for (auto entry = entries_.begin(); entry != entries_.end(); ) {
    const bool old = entry->second.ended && now - entry->second.ended > result_timeout_;
    if (old) {forget(entry->first);}
    entry = old ? entries_.erase(entry) : std::next(entry);
  }
}

void ServerBase::cancel(const CancelGoal::Request & request, CancelGoal::Response & response)
{
  const auto & asked = request.goal_info.goal_id.uuid;
  const rclcpp::Time before(request.goal_info.stamp);
  const bool one = asked != GoalUUID{};
  const bool timed = before.nanoseconds() != 0;
  const auto found = entries_.find(asked);
  if (one && !timed && found == entries_.end()) {
    response.return_code = CancelGoal::Response::ERROR_UNKNOWN_GOAL_ID;
    return;
  }
  if (one && !timed && found->second.ended) {
    response.return_code = CancelGoal::Response::ERROR_GOAL_TERMINATED;
    return;
  }
  bool any = false;
  const auto entries = entries_;  // callbacks may change them
  for (const auto & [id, entry] : entries) {
    const bool meant = (!one && !timed) || (one && id == asked) ||
      (timed && rclcpp::Time(entry.stamp) <= before);
    const bool can_be = entry.status == GoalStatus::STATUS_ACCEPTED ||
      entry.status == GoalStatus::STATUS_EXECUTING;
    if (!meant || !can_be) {continue;}
    any = true;
    if (!agree_to_cancel(id)) {continue;}
    const auto handle = entry.handle.lock();
    if (!handle || !handle->is_active() || handle->is_canceling()) {continue;}
    handle->change(GoalStatus::STATUS_CANCELING, "CANCEL_GOAL");
    entries_.at(id).status = GoalStatus::STATUS_CANCELING;
    GoalInfo info;
    info.goal_id.uuid = id;
    info.stamp = entry.stamp;
    response.goals_canceling.push_back(info);
  }
  const bool rejected = any && response.goals_canceling.empty();
  response.return_code = rejected ? CancelGoal::Response::ERROR_REJECTED :
    CancelGoal::Response::ERROR_NONE;
  if (!response.goals_canceling.empty()) {publish_status();}
}

}  // namespace rclcpp_action
