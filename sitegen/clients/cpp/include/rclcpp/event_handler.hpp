// The events of publishers and subscriptions, and their callbacks.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/detail/host.h"
#include "rclcpp/waitable.hpp"
#include "rmw/types.h"

namespace rclcpp
{

using QOSDeadlineOfferedInfo = rmw_offered_deadline_missed_status_t;
using QOSDeadlineRequestedInfo = rmw_requested_deadline_missed_status_t;
using QOSLivelinessLostInfo = rmw_liveliness_lost_status_t;
using QOSLivelinessChangedInfo = rmw_liveliness_changed_status_t;
using QOSMessageLostInfo = rmw_message_lost_status_t;
using QOSOfferedIncompatibleQoSInfo = rmw_offered_qos_incompatible_event_status_t;
using QOSRequestedIncompatibleQoSInfo = rmw_requested_qos_incompatible_event_status_t;
using IncompatibleTypeInfo = rmw_incompatible_type_status_t;
using MatchedInfo = rmw_matched_status_t;
using PublisherMatchedInfo = rmw_matched_status_t;
using SubscriptionMatchedInfo = rmw_matched_status_t;

using QOSDeadlineOfferedCallbackType = std::function<void (QOSDeadlineOfferedInfo &)>;
using QOSDeadlineRequestedCallbackType = std::function<void (QOSDeadlineRequestedInfo &)>;
using QOSLivelinessLostCallbackType = std::function<void (QOSLivelinessLostInfo &)>;
using QOSLivelinessChangedCallbackType = std::function<void (QOSLivelinessChangedInfo &)>;
using QOSMessageLostCallbackType = std::function<void (QOSMessageLostInfo &)>;
using QOSOfferedIncompatibleQoSCallbackType =
  std::function<void (QOSOfferedIncompatibleQoSInfo &)>;
using QOSRequestedIncompatibleQoSCallbackType =
  std::function<void (QOSRequestedIncompatibleQoSInfo &)>;
using IncompatibleTypeCallbackType = std::function<void (IncompatibleTypeInfo &)>;
using PublisherMatchedCallbackType = std::function<void (MatchedInfo &)>;
using SubscriptionMatchedCallbackType = std::function<void (MatchedInfo &)>;

struct PublisherEventCallbacks
{
  QOSDeadlineOfferedCallbackType deadline_callback;
  QOSLivelinessLostCallbackType liveliness_callback;
  QOSOfferedIncompatibleQoSCallbackType incompatible_qos_callback;
  IncompatibleTypeCallbackType incompatible_type_callback;
  PublisherMatchedCallbackType matched_callback;
};

struct SubscriptionEventCallbacks
{
  QOSDeadlineRequestedCallbackType deadline_callback;
  QOSLivelinessChangedCallbackType liveliness_callback;
  QOSRequestedIncompatibleQoSCallbackType incompatible_qos_callback;
  QOSMessageLostCallbackType message_lost_callback;
  IncompatibleTypeCallbackType incompatible_type_callback;
  SubscriptionMatchedCallbackType matched_callback;
};

namespace detail
{

/// The event callbacks of one endpoint.
class Events : public Waitable
{
public:
  using Waitable::execute;
  /// With `defaults`, incompatible QoS is logged by `logger` unless there is a callback for it.
  Events(
    std::int32_t endpoint, const PublisherEventCallbacks & callbacks, bool defaults,
    const std::string & logger, const std::string & topic);
  Events(
    std::int32_t endpoint, const SubscriptionEventCallbacks & callbacks, bool defaults,
    const std::string & logger, const std::string & topic);

  /// Record the events since the last call; false if there were none.
  bool look() override;
  /// Run the callbacks for recorded events.
  void execute(const std::shared_ptr<void> & data) override;

private:
  using Call = std::function<void (const ros_event &)>;

  template<class StatusT, class CallbackT>
  void on(std::int32_t kind, const CallbackT & callback, StatusT (* status)(const ros_event &));

  std::int32_t endpoint_;
  /// The program's number of events at the last check.
  std::uint32_t seen_ = 0;
  std::vector<std::pair<std::int32_t, Call>> calls_;
  std::vector<std::function<void()>> noted_;
};

}  // namespace detail
}  // namespace rclcpp
