#pragma once

#include <memory>
#include <utility>

#include "rclcpp/logging.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp_lifecycle/managed_entity.hpp"

namespace rclcpp_lifecycle
{

class LifecyclePublisherInterface : public SimpleManagedEntity
{
};

/// Publishes while its node is active.
template<typename MessageT, typename AllocatorT = std::allocator<void>>
class LifecyclePublisher : public LifecyclePublisherInterface,
  public rclcpp::Publisher<MessageT, AllocatorT>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecyclePublisher<MessageT, AllocatorT>)

  using rclcpp::Publisher<MessageT, AllocatorT>::Publisher;

  template<class T>
  void publish(T && message)
  {
    if (is_activated()) {
      rclcpp::Publisher<MessageT, AllocatorT>::publish(std::forward<T>(message));
      should_log_ = true;
    } else if (std::exchange(should_log_, false)) {
      RCLCPP_WARN(
        rclcpp::get_logger("LifecyclePublisher"),
        "Trying to publish message on the topic '%s', but the publisher is not activated",
        this->get_topic_name());
    }
  }

private:
  bool should_log_ = true;
};

}  // namespace rclcpp_lifecycle
