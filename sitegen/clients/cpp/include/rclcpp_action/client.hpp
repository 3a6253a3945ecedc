#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "action_msgs/msg/goal_status_array.hpp"
#include "action_msgs/srv/cancel_goal.hpp"
#include "rclcpp/client.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp_action/client_goal_handle.hpp"
#include "rclcpp_action/types.hpp"

struct rcl_action_client_options_t
{
  rmw_qos_profile_t goal_service_qos = rmw_qos_profile_services_default;
  rmw_qos_profile_t result_service_qos = rmw_qos_profile_services_default;
  rmw_qos_profile_t cancel_service_qos = rmw_qos_profile_services_default;
  rmw_qos_profile_t feedback_topic_qos = rmw_qos_profile_default;
  rmw_qos_profile_t status_topic_qos = rclcpp::QoS(1).transient_local().get_rmw_qos_profile();
};

inline rcl_action_client_options_t rcl_action_client_get_default_options() {return {};}

namespace rclcpp_action
{

class ClientBase
{
public:
  virtual ~ClientBase() = default;

  virtual bool action_server_is_ready() const = 0;
  /// Wait until a server is available; false on timeout or shutdown.
  template<class Rep = std::int64_t, class Period = std::milli>
  bool wait_for_action_server(
    std::chrono::duration<Rep, Period> timeout = std::chrono::duration<Rep, Period>(-1))
  {
    return wait(std::chrono::duration<double, std::milli>(timeout).count());
  }

private:
  bool wait(double milliseconds) const;
};

template<typename ActionT>
class Client : public ClientBase, public std::enable_shared_from_this<Client<ActionT>>
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(Client)
  RCLCPP_DISABLE_COPY(Client)

  using Goal = typename ActionT::Goal;
  using Feedback = typename ActionT::Feedback;
  using GoalHandle = ClientGoalHandle<ActionT>;
  using WrappedResult = typename GoalHandle::WrappedResult;
  using GoalResponseCallback = std::function<void (typename GoalHandle::SharedPtr)>;
  using FeedbackCallback = typename GoalHandle::FeedbackCallback;
  using ResultCallback = typename GoalHandle::ResultCallback;
  using CancelRequest = typename ActionT::Impl::CancelGoalService::Request;
  using CancelResponse = typename ActionT::Impl::CancelGoalService::Response;
  using CancelCallback = std::function<void (typename CancelResponse::SharedPtr)>;

  struct SendGoalOptions
  {
    /// Called with a null handle if the server rejected the goal.
    GoalResponseCallback goal_response_callback;
    FeedbackCallback feedback_callback;
    ResultCallback result_callback;
  };

  Client(
    rclcpp::node_interfaces::NodeBaseInterface & node, const std::string & name,
    const rclcpp::CallbackGroup::SharedPtr & group)
  : goal_client_(make<SendGoal>(node, name + "/_action/send_goal", group)),
    cancel_client_(make<CancelGoal>(node, name + "/_action/cancel_goal", group)),
    result_client_(make<GetResult>(node, name + "/_action/get_result", group)),
    feedback_(
      std::make_shared<rclcpp::Subscription<FeedbackMessage>>(
        node, name + "/_action/feedback", rclcpp::QoS(10),
        [this](std::shared_ptr<FeedbackMessage> message) {take_feedback(std::move(message));})),
    status_(
      std::make_shared<rclcpp::Subscription<StatusMessage>>(
        node, name + "/_action/status", rclcpp::QoS(1).transient_local(),
        [this](const StatusMessage & message) {take_status(message);}))
  {
    node.add(rclcpp::detail::ExecutableKind::kSubscription, feedback_, group);
    node.add(rclcpp::detail::ExecutableKind::kSubscription, status_, group);
  }

  bool action_server_is_ready() const override
  {
    return goal_client_->service_is_ready() && cancel_client_->service_is_ready() &&
           result_client_->service_is_ready() && feedback_->get_publisher_count() > 0 &&
           status_->get_publisher_count() > 0;
  }

  std::shared_future<typename GoalHandle::SharedPtr> async_send_goal(
    const Goal & goal, const SendGoalOptions & options = SendGoalOptions())
  {
    auto promise = std::make_shared<std::promise<typename GoalHandle::SharedPtr>>();
    auto future = promise->get_future().share();
    auto request = std::make_shared<typename SendGoal::Request>();
    request->goal_id.uuid = make_goal_id();
    request->goal = goal;
    goal_client_->async_send_request(
      request, [this, promise, request, options](
        typename rclcpp::Client<SendGoal>::SharedFuture answer) {
        const auto response = answer.get();
        if (!response->accepted) {
          promise->set_value(nullptr);
          if (options.goal_response_callback) {options.goal_response_callback(nullptr);}
          return;
        }
        GoalInfo info;
        info.goal_id = request->goal_id;
        info.stamp = response->stamp;
        auto handle = std::make_shared<GoalHandle>(
          info, options.feedback_callback, options.result_callback);
        handles_[info.goal_id.uuid] = handle;
        promise->set_value(handle);
        if (options.goal_response_callback) {options.goal_response_callback(handle);}
        if (options.result_callback) {ask_result(handle);}
      });
    return future;
  }

  /// Throws UnknownGoalHandleError for a goal of another client.
  std::shared_future<WrappedResult> async_get_result(
    typename GoalHandle::SharedPtr handle, ResultCallback callback = nullptr)
  {
    require(handle);
    if (callback) {handle->result_callback_ = std::move(callback);}
    ask_result(handle);
    return handle->result_;
  }

  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_goal(
    typename GoalHandle::SharedPtr handle, CancelCallback callback = nullptr)
  {
    require(handle);
    auto request = std::make_shared<CancelRequest>();
    request->goal_info.goal_id.uuid = handle->get_goal_id();
    return cancel(request, std::move(callback));
  }
  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_all_goals(
    CancelCallback callback = nullptr)
  {
    return cancel(std::make_shared<CancelRequest>(), std::move(callback));
  }
  std::shared_future<typename CancelResponse::SharedPtr> async_cancel_goals_before(
    const rclcpp::Time & stamp, CancelCallback callback = nullptr)
  {
    auto request = std::make_shared<CancelRequest>();
    request->goal_info.stamp = stamp;
    return cancel(request, std::move(callback));
  }

  void stop_callbacks(typename GoalHandle::SharedPtr handle)
  {
    handle->feedback_callback_ = nullptr;
    handle->result_callback_ = nullptr;
  }
  void stop_callbacks(const GoalUUID & id)
  {
    if (const auto handle = find(id)) {stop_callbacks(handle);}
  }

private:
  using SendGoal = typename ActionT::Impl::SendGoalService;
  using GetResult = typename ActionT::Impl::GetResultService;
  using CancelGoal = typename ActionT::Impl::CancelGoalService;
  using FeedbackMessage = typename ActionT::Impl::FeedbackMessage;
  using StatusMessage = typename ActionT::Impl::GoalStatusMessage;

  template<class ServiceT>
  static std::shared_ptr<rclcpp::Client<ServiceT>> make(
    rclcpp::node_interfaces::NodeBaseInterface & node, const std::string & name,
    const rclcpp::CallbackGroup::SharedPtr & group)
  {
    auto client = std::make_shared<rclcpp::Client<ServiceT>>(node, name, rclcpp::QoS(10));
    node.add(rclcpp::detail::ExecutableKind::kClient, client, group);
    return client;
  }

  typename GoalHandle::SharedPtr find(const GoalUUID & id)
  {
    const auto found = handles_.find(id);
    return found == handles_.end() ? nullptr : found->second.lock();
  }
  void require(const typename GoalHandle::SharedPtr & handle)
  {
    if (!handle || find(handle->get_goal_id()) != handle) {
      throw exceptions::UnknownGoalHandleError();
    }
  }

  void ask_result(typename GoalHandle::SharedPtr handle)
  {
    if (std::exchange(handle->is_result_aware_, true)) {return;}
    auto request = std::make_shared<typename GetResult::Request>();
    request->goal_id.uuid = handle->get_goal_id();
    result_client_->async_send_request(
      request, [this, handle](typename rclcpp::Client<GetResult>::SharedFuture answer) {
        const auto response = answer.get();
        WrappedResult wrapped;
        wrapped.goal_id = handle->get_goal_id();
        wrapped.code = static_cast<ResultCode>(response->status);
        wrapped.result = std::make_shared<typename ActionT::Result>(response->result);
        handle->status_ = response->status;
        handle->promise_.set_value(wrapped);
        if (handle->result_callback_) {handle->result_callback_(wrapped);}
        handles_.erase(handle->get_goal_id());
      });
  }

  std::shared_future<typename CancelResponse::SharedPtr> cancel(
    typename CancelRequest::SharedPtr request, CancelCallback callback)
  {
    auto promise = std::make_shared<std::promise<typename CancelResponse::SharedPtr>>();
    auto future = promise->get_future().share();
    cancel_client_->async_send_request(
      request, [promise, callback = std::move(callback)](
        typename rclcpp::Client<CancelGoal>::SharedFuture answer) {
        promise->set_value(answer.get());
        if (callback) {callback(answer.get());}
      });
    return future;
  }

  void take_feedback(std::shared_ptr<FeedbackMessage> message)
  {
    const auto handle = find(message->goal_id.uuid);
    if (!handle || !handle->feedback_callback_) {return;}
    std::shared_ptr<const Feedback> feedback(message, &message->feedback);
    handle->feedback_callback_(handle, feedback);
  }

  void take_status(const StatusMessage & message)
  {
    for (const auto & status : message.status_list) {
      if (const auto handle = find(status.goal_info.goal_id.uuid)) {
        handle->status_ = status.status;
      }
    }
    // Handles that no program holds any more.
    for (auto handle = handles_.begin(); handle != handles_.end(); ) {
      handle = handle->second.expired() ? handles_.erase(handle) : std::next(handle);
    }
  }

  std::map<GoalUUID, typename GoalHandle::WeakPtr> handles_;
  std::shared_ptr<rclcpp::Client<SendGoal>> goal_client_;
  std::shared_ptr<rclcpp::Client<CancelGoal>> cancel_client_;
  std::shared_ptr<rclcpp::Client<GetResult>> result_client_;
  std::shared_ptr<rclcpp::Subscription<FeedbackMessage>> feedback_;
  std::shared_ptr<rclcpp::Subscription<StatusMessage>> status_;
};

/// `node` is a pointer to an object with get_node_base_interface().
template<typename ActionT, typename NodeT>
typename Client<ActionT>::SharedPtr create_client(
  NodeT node, const std::string & name, rclcpp::CallbackGroup::SharedPtr group = nullptr,
  const rcl_action_client_options_t & = rcl_action_client_get_default_options())
{
  return std::make_shared<Client<ActionT>>(*node->get_node_base_interface(), name, group);
}

/// With individual interfaces in place of a node.
template<typename ActionT, typename GraphT, typename LoggingT, typename WaitablesT>
typename Client<ActionT>::SharedPtr create_client(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, std::shared_ptr<GraphT>,
  std::shared_ptr<LoggingT>, std::shared_ptr<WaitablesT>, const std::string & name,
  rclcpp::CallbackGroup::SharedPtr group = nullptr,
  const rcl_action_client_options_t & = rcl_action_client_get_default_options())
{
  return std::make_shared<Client<ActionT>>(*node, name, group);
}

}  // namespace rclcpp_action
