#include "rclcpp/event_handler.hpp"

#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp
{
namespace detail
{

namespace
{

// The same values for both sides, under different names.
rmw_offered_deadline_missed_status_t deadline(const ros_event & event)
{
  return {event.total, event.total_change};
}

rmw_liveliness_lost_status_t lost_liveliness(const ros_event & event)
{
  return {event.total, event.total_change};
}

rmw_liveliness_changed_status_t liveliness(const ros_event & event)
{
  return {event.current, event.total, event.current_change, event.total_change};
}

rmw_qos_incompatible_event_status_t incompatible(const ros_event & event)
{
  return {event.total, event.total_change, rmw_qos_policy_kind_t(event.policy)};
}

rmw_incompatible_type_status_t type(const ros_event & event)
{
  return {event.total, event.total_change};
}

rmw_message_lost_status_t lost(const ros_event & event)
{
  return {static_cast<std::size_t>(event.total), static_cast<std::size_t>(event.total_change)};
}

rmw_matched_status_t matched(const ros_event & event)
{
  return {
    static_cast<std::size_t>(event.total), static_cast<std::size_t>(event.total_change),
    static_cast<std::size_t>(event.current), event.current_change};
}

std::string last_policy(const rmw_qos_incompatible_event_status_t & status)
{
  return qos_policy_name_from_kind(status.last_policy_kind);
}

}  // namespace

template<class StatusT, class CallbackT>
void Events::on(
  std::int32_t kind, const CallbackT & callback, StatusT (* status)(const ros_event &))
{
  if (!callback) {return;}
  calls_.emplace_back(
    kind, [callback, status](const ros_event & event) {
      auto told = status(event);
      callback(told);
    });
}

Events::Events(
  std::int32_t endpoint, const PublisherEventCallbacks & callbacks, bool defaults,
  const std::string & logger, const std::string & topic)
: endpoint_(endpoint)
{
  auto on_incompatible = callbacks.incompatible_qos_callback;
  auto on_type = callbacks.incompatible_type_callback;
  if (defaults && !on_incompatible) {
    on_incompatible = [logger, topic](QOSOfferedIncompatibleQoSInfo & info) {
        RCLCPP_WARN(
          get_logger(logger),
          "New subscription discovered on topic '%s', requesting incompatible QoS. "
          "No messages will be sent to it. Last incompatible policy: %s",
          topic.c_str(), last_policy(info).c_str());
      };
  }
  if (defaults && !on_type) {
    on_type = [logger, topic](IncompatibleTypeInfo &) {
        RCLCPP_WARN(
          get_logger(logger), "Incompatible type on topic '%s', no messages will be sent to it.",
          topic.c_str());
      };
  }
  on(ROS_EVENT_DEADLINE, callbacks.deadline_callback, deadline);
  on(ROS_EVENT_LIVELINESS, callbacks.liveliness_callback, lost_liveliness);
  on(ROS_EVENT_INCOMPATIBLE, on_incompatible, incompatible);
  on(ROS_EVENT_TYPE, on_type, type);
  on(ROS_EVENT_MATCHED, callbacks.matched_callback, matched);
}

Events::Events(
  std::int32_t endpoint, const SubscriptionEventCallbacks & callbacks, bool defaults,
  const std::string & logger, const std::string & topic)
: endpoint_(endpoint)
{
  auto on_incompatible = callbacks.incompatible_qos_callback;
  auto on_type = callbacks.incompatible_type_callback;
  if (defaults && !on_incompatible) {
    on_incompatible = [logger, topic](QOSRequestedIncompatibleQoSInfo & info) {
        RCLCPP_WARN(
          get_logger(logger),
          "New publisher discovered on topic '%s', offering incompatible QoS. "
          "No messages will be received from it. Last incompatible policy: %s",
          topic.c_str(), last_policy(info).c_str());
      };
  }
  if (defaults && !on_type) {
    on_type = [logger, topic](IncompatibleTypeInfo &) {
        RCLCPP_WARN(
          get_logger(logger),
          "Incompatible type on topic '%s', no messages will be received from it.",
          topic.c_str());
      };
  }
  on(ROS_EVENT_DEADLINE, callbacks.deadline_callback, deadline);
  on(ROS_EVENT_LIVELINESS, callbacks.liveliness_callback, liveliness);
  on(ROS_EVENT_INCOMPATIBLE, on_incompatible, incompatible);
  on(ROS_EVENT_LOST, callbacks.message_lost_callback, lost);
  on(ROS_EVENT_TYPE, on_type, type);
  on(ROS_EVENT_MATCHED, callbacks.matched_callback, matched);
}

bool Events::look()
{
  const std::uint32_t events = ros_events();
  if (events == seen_) {return !noted_.empty();}
  seen_ = events;
  for (const auto & [kind, call] : calls_) {
    ros_event event;
    if (ros_take_event(endpoint_, kind, &event)) {
      noted_.push_back([call = call, event] {call(event);});
    }
  }
  return !noted_.empty();
}

void Events::execute(const std::shared_ptr<void> &)
{
  // Further events may be recorded during the callbacks.
  for (const auto & call : std::exchange(noted_, {})) {call();}
}

}  // namespace detail
}  // namespace rclcpp
