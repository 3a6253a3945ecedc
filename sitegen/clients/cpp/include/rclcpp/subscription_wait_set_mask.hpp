#pragma once

namespace rclcpp
{

/// The parts of a subscription that a wait set waits for.
class SubscriptionWaitSetMask
{
public:
  bool include_subscription = true;
  bool include_events = true;
  bool include_intra_process_waitable = true;
};

}  // namespace rclcpp
