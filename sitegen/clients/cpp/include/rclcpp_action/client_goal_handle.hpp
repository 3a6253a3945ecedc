#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <utility>

#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_action/exceptions.hpp"
#include "rclcpp_action/types.hpp"

namespace rclcpp_action
{

enum class ResultCode : std::int8_t
{
  UNKNOWN = GoalStatus::STATUS_UNKNOWN,
  SUCCEEDED = GoalStatus::STATUS_SUCCEEDED,
  CANCELED = GoalStatus::STATUS_CANCELED,
  ABORTED = GoalStatus::STATUS_ABORTED
};

template<typename ActionT>
class Client;

/// The handle of a goal for its client.
template<typename ActionT>
class ClientGoalHandle
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ClientGoalHandle)
  RCLCPP_DISABLE_COPY(ClientGoalHandle)

  struct WrappedResult
  {
    GoalUUID goal_id;
    ResultCode code;
    typename ActionT::Result::SharedPtr result;
  };

  using Feedback = typename ActionT::Feedback;
  using Result = typename ActionT::Result;
  using FeedbackCallback =
    std::function<void (ClientGoalHandle::SharedPtr, const std::shared_ptr<const Feedback>)>;
  using ResultCallback = std::function<void (const WrappedResult & result)>;

  ClientGoalHandle(
    const GoalInfo & info, FeedbackCallback feedback_callback, ResultCallback result_callback)
  : info_(info), feedback_callback_(std::move(feedback_callback)),
    result_callback_(std::move(result_callback)) {}

  const GoalUUID & get_goal_id() const {return info_.goal_id.uuid;}
  rclcpp::Time get_goal_stamp() const {return info_.stamp;}
  std::int8_t get_status() const {return status_;}
  bool is_feedback_aware() const {return static_cast<bool>(feedback_callback_);}
  bool is_result_aware() const {return is_result_aware_;}

private:
  friend class Client<ActionT>;

  GoalInfo info_;
  FeedbackCallback feedback_callback_;
  ResultCallback result_callback_;
  bool is_result_aware_ = false;
  std::int8_t status_ = GoalStatus::STATUS_ACCEPTED;
  std::promise<WrappedResult> promise_;
  std::shared_future<WrappedResult> result_ = promise_.get_future().share();
};

}  // namespace rclcpp_action
