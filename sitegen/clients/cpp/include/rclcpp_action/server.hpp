#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "action_msgs/msg/goal_status_array.hpp"
#include "action_msgs/srv/cancel_goal.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp_action/server_goal_handle.hpp"
#include "rclcpp_action/types.hpp"

struct rcl_action_server_options_t
{
  rmw_qos_profile_t goal_service_qos = rmw_qos_profile_services_default;
  rmw_qos_profile_t cancel_service_qos = rmw_qos_profile_services_default;
  rmw_qos_profile_t result_service_qos = rmw_qos_profile_services_default;
  rmw_qos_profile_t feedback_topic_qos = rmw_qos_profile_default;
  rmw_qos_profile_t status_topic_qos = rclcpp::QoS(1).transient_local().get_rmw_qos_profile();
  struct {std::int64_t nanoseconds;} result_timeout = {10000000000};
};

inline rcl_action_server_options_t rcl_action_server_get_default_options() {return {};}

namespace rclcpp_action
{

enum class GoalResponse : std::int8_t {REJECT = 1, ACCEPT_AND_EXECUTE = 2, ACCEPT_AND_DEFER = 3};
enum class CancelResponse : std::int8_t {REJECT = 1, ACCEPT = 2};

/// The common part of servers for all actions: the goals, and how they are canceled.
class ServerBase
{
public:
  virtual ~ServerBase() = default;

protected:
  using CancelGoal = action_msgs::srv::CancelGoal;

  struct Entry
  {
    builtin_interfaces::msg::Time stamp;
    std::weak_ptr<ServerGoalHandleBase> handle;
    std::int8_t status = GoalStatus::STATUS_ACCEPTED;
    std::int64_t ended = 0;  // ns, when it did
    std::vector<rmw_request_id_t> waiting;  // for its result
  };

  ServerBase(
    rclcpp::node_interfaces::NodeBaseInterface & node, const std::string & name,
    const rcl_action_server_options_t & options, const rclcpp::CallbackGroup::SharedPtr & group);

  /// The response of the goal to a request to cancel it.
  virtual bool agree_to_cancel(const GoalUUID & id) = 0;
  virtual void forget(const GoalUUID & id) = 0;
  void publish_status();
  /// Remove goals whose results have expired.
  void forget_old();

  std::map<GoalUUID, Entry> entries_;
  rclcpp::Clock clock_;

private:
  void cancel(const CancelGoal::Request & request, CancelGoal::Response & response);

  std::int64_t result_timeout_;
  std::shared_ptr<rclcpp::Service<CancelGoal>> cancel_service_;
  std::shared_ptr<rclcpp::Publisher<action_msgs::msg::GoalStatusArray>> status_publisher_;
};

template<typename ActionT>
class Server : public ServerBase, public std::enable_shared_from_this<Server<ActionT>>
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(Server)
  RCLCPP_DISABLE_COPY(Server)

  using GoalHandle = ServerGoalHandle<ActionT>;
  using GoalCallback =
    std::function<GoalResponse(const GoalUUID &, std::shared_ptr<const typename ActionT::Goal>)>;
  using CancelCallback = std::function<CancelResponse(std::shared_ptr<GoalHandle>)>;
  using AcceptedCallback = std::function<void (std::shared_ptr<GoalHandle>)>;

  Server(
    rclcpp::node_interfaces::NodeBaseInterface & node, const std::string & name,
    const rcl_action_server_options_t & options, GoalCallback handle_goal,
    CancelCallback handle_cancel, AcceptedCallback handle_accepted,
    const rclcpp::CallbackGroup::SharedPtr & group)
  : ServerBase(node, name, options, group), handle_goal_(std::move(handle_goal)),
    handle_cancel_(std::move(handle_cancel)), handle_accepted_(std::move(handle_accepted))
  {
    goal_service_ = std::make_shared<rclcpp::Service<SendGoal>>(
      node, name + "/_action/send_goal", rclcpp::QoS(10),
      [this](std::shared_ptr<rmw_request_id_t> id, std::shared_ptr<typename SendGoal::Request> request) {
        take_goal(*id, std::move(request));
      });
    result_service_ = std::make_shared<rclcpp::Service<GetResult>>(
      node, name + "/_action/get_result", rclcpp::QoS(10),
      [this](std::shared_ptr<rmw_request_id_t> id, std::shared_ptr<typename GetResult::Request> request) {
        tell_result(*id, request->goal_id.uuid);
      });
    node.add(rclcpp::detail::ExecutableKind::kService, goal_service_, group);
    node.add(rclcpp::detail::ExecutableKind::kService, result_service_, group);
    feedback_publisher_ = std::make_shared<rclcpp::Publisher<FeedbackMessage>>(
      node, name + "/_action/feedback", rclcpp::QoS(10));
  }

protected:
  bool agree_to_cancel(const GoalUUID & id) override
  {
    const auto handle =
      std::static_pointer_cast<GoalHandle>(this->entries_.at(id).handle.lock());
    return handle && handle_cancel_(handle) == CancelResponse::ACCEPT;
  }
  void forget(const GoalUUID & id) override {results_.erase(id);}

private:
  using SendGoal = typename ActionT::Impl::SendGoalService;
  using GetResult = typename ActionT::Impl::GetResultService;
  using FeedbackMessage = typename ActionT::Impl::FeedbackMessage;

  void take_goal(rmw_request_id_t & id, std::shared_ptr<typename SendGoal::Request> request)
  {
    this->forget_old();
    const GoalUUID uuid = request->goal_id.uuid;
    typename SendGoal::Response response;
    response.stamp = this->clock_.now();
    // The goal is a part of the request, and shares its lifetime.
    std::shared_ptr<const typename ActionT::Goal> goal(request, &request->goal);
    const bool known = this->entries_.count(uuid) != 0;
    const auto answer = known ? GoalResponse::REJECT : handle_goal_(uuid, goal);
    response.accepted = answer != GoalResponse::REJECT;
    goal_service_->send_response(id, response);
    if (!response.accepted) {return;}

    // A goal handle may outlive its server; then there is nothing to notify.
    std::weak_ptr<Server> weak = this->weak_from_this();
    auto handle = std::make_shared<GoalHandle>(
      uuid, goal,
      [weak, uuid] {
        if (auto self = weak.lock()) {self->note(uuid, GoalStatus::STATUS_EXECUTING);}
      },
      [weak, uuid](std::int8_t status, const typename ActionT::Result & result) {
        if (auto self = weak.lock()) {self->end(uuid, status, result);}
      },
      [weak, uuid](const typename ActionT::Feedback & feedback) {
        if (auto self = weak.lock()) {self->publish_feedback(uuid, feedback);}
      });
    auto & entry = this->entries_[uuid];
    entry.stamp = response.stamp;
    entry.handle = handle;
    if (answer == GoalResponse::ACCEPT_AND_EXECUTE) {
      handle->execute();
    } else {
      this->publish_status();
    }
    handle_accepted_(std::move(handle));
  }

  void note(const GoalUUID & id, std::int8_t status)
  {
    this->entries_.at(id).status = status;
    this->publish_status();
  }

  void end(const GoalUUID & id, std::int8_t status, const typename ActionT::Result & result)
  {
    auto & response = results_[id];
    response.status = status;
    response.result = result;
    auto & entry = this->entries_.at(id);
    entry.ended = this->clock_.now().nanoseconds();
    for (auto & request : entry.waiting) {result_service_->send_response(request, response);}
    entry.waiting.clear();
    note(id, status);
  }

  void tell_result(rmw_request_id_t & request, const GoalUUID & id)
  {
    const auto found = results_.find(id);
    if (found != results_.end()) {
      result_service_->send_response(request, found->second);
    } else if (this->entries_.count(id)) {
      this->entries_.at(id).waiting.push_back(request);
    } else {
      typename GetResult::Response unknown;
      unknown.status = GoalStatus::STATUS_UNKNOWN;
      result_service_->send_response(request, unknown);
    }
  }

  void publish_feedback(const GoalUUID & id, const typename ActionT::Feedback & feedback)
  {
    FeedbackMessage message;
    message.goal_id.uuid = id;
    message.feedback = feedback;
    feedback_publisher_->publish(message);
  }

  GoalCallback handle_goal_;
  CancelCallback handle_cancel_;
  AcceptedCallback handle_accepted_;
  std::map<GoalUUID, typename GetResult::Response> results_;
  std::shared_ptr<rclcpp::Service<SendGoal>> goal_service_;
  std::shared_ptr<rclcpp::Service<GetResult>> result_service_;
  std::shared_ptr<rclcpp::Publisher<FeedbackMessage>> feedback_publisher_;
};

/// `node` is a pointer to an object with get_node_base_interface().
template<typename ActionT, typename NodeT>
typename Server<ActionT>::SharedPtr create_server(
  NodeT node, const std::string & name, typename Server<ActionT>::GoalCallback handle_goal,
  typename Server<ActionT>::CancelCallback handle_cancel,
  typename Server<ActionT>::AcceptedCallback handle_accepted,
  const rcl_action_server_options_t & options = rcl_action_server_get_default_options(),
  rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  return std::make_shared<Server<ActionT>>(
    *node->get_node_base_interface(), name, options, std::move(handle_goal),
    std::move(handle_cancel), std::move(handle_accepted), group);
}

/// With individual interfaces in place of a node.
template<typename ActionT, typename ClockT, typename LoggingT, typename WaitablesT>
typename Server<ActionT>::SharedPtr create_server(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, std::shared_ptr<ClockT>,
  std::shared_ptr<LoggingT>, std::shared_ptr<WaitablesT>, const std::string & name,
  typename Server<ActionT>::GoalCallback handle_goal,
  typename Server<ActionT>::CancelCallback handle_cancel,
  typename Server<ActionT>::AcceptedCallback handle_accepted,
  const rcl_action_server_options_t & options = rcl_action_server_get_default_options(),
  rclcpp::CallbackGroup::SharedPtr group = nullptr)
{
  return create_server<ActionT>(
    node, name, std::move(handle_goal), std::move(handle_cancel), std::move(handle_accepted),
    options, group);
}

}  // namespace rclcpp_action
