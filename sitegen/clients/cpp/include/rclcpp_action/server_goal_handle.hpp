#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

#include "rclcpp/macros.hpp"
#include "rclcpp_action/types.hpp"

namespace rclcpp_action
{

/// The state machine of a goal. Invalid transitions throw rclcpp::exceptions::RCLError.
class ServerGoalHandleBase
{
public:
  virtual ~ServerGoalHandleBase() = default;

  bool is_canceling() const {return status_ == GoalStatus::STATUS_CANCELING;}
  bool is_active() const {return status_ <= GoalStatus::STATUS_CANCELING;}
  bool is_executing() const {return status_ == GoalStatus::STATUS_EXECUTING;}
  std::int8_t status() const {return status_;}

protected:
  friend class ServerBase;

  /// Change to `status` because of `event`.
  void change(std::int8_t status, const char * event);

private:
  std::int8_t status_ = GoalStatus::STATUS_ACCEPTED;
};

/// The handle of a goal for its server. A goal whose handle is destroyed before it ended is
/// canceled.
template<typename ActionT>
class ServerGoalHandle : public ServerGoalHandleBase
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(ServerGoalHandle)
  RCLCPP_DISABLE_COPY(ServerGoalHandle)

  using Goal = typename ActionT::Goal;
  using Result = typename ActionT::Result;
  using Feedback = typename ActionT::Feedback;
  using OnChange = std::function<void ()>;
  using OnEnd = std::function<void (std::int8_t status, const Result & result)>;
  using OnFeedback = std::function<void (const Feedback & feedback)>;

  ServerGoalHandle(
    const GoalUUID & id, std::shared_ptr<const Goal> goal, OnChange on_change, OnEnd on_end,
    OnFeedback on_feedback)
  : id_(id), goal_(std::move(goal)), on_change_(std::move(on_change)),
    on_end_(std::move(on_end)), on_feedback_(std::move(on_feedback)) {}

  ~ServerGoalHandle() override
  {
    if (!is_active()) {return;}
    if (!is_canceling()) {change(GoalStatus::STATUS_CANCELING, "CANCEL_GOAL");}
    change(GoalStatus::STATUS_CANCELED, "CANCELED");
    on_end_(status(), Result());
  }

  std::shared_ptr<const Goal> get_goal() const {return goal_;}
  const GoalUUID & get_goal_id() const {return id_;}

  void publish_feedback(std::shared_ptr<Feedback> feedback) {on_feedback_(*feedback);}
  /// Start a goal that was accepted with ACCEPT_AND_DEFER.
  void execute()
  {
    change(GoalStatus::STATUS_EXECUTING, "EXECUTE");
    on_change_();
  }
  void succeed(std::shared_ptr<Result> result)
  {
    end(GoalStatus::STATUS_SUCCEEDED, "SUCCEED", *result);
  }
  void abort(std::shared_ptr<Result> result)
  {
    end(GoalStatus::STATUS_ABORTED, "ABORT", *result);
  }
  void canceled(std::shared_ptr<Result> result)
  {
    end(GoalStatus::STATUS_CANCELED, "CANCELED", *result);
  }

private:
  void end(std::int8_t status, const char * event, const Result & result)
  {
    change(status, event);
    on_end_(status, result);
  }

  GoalUUID id_;
  std::shared_ptr<const Goal> goal_;
  OnChange on_change_;
  OnEnd on_end_;
  OnFeedback on_feedback_;
};

}  // namespace rclcpp_action
