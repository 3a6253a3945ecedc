#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "message_filters/connection.hpp"
#include "message_filters/simple_filter.hpp"
#include "rclcpp/create_subscription.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/type_adapter.hpp"

namespace message_filters
{

/// A filter that receives the messages of a topic. Older programs name the type of the node as a
/// second parameter.
template<class M, class ...>
class Subscriber : public SimpleFilter<rclcpp::detail::custom_type<M>>
{
public:
  using MessageType = rclcpp::detail::custom_type<M>;
  using EventType = MessageEvent<MessageType const>;

  Subscriber() = default;
  /// `node` is a node, or a pointer to one.
  template<class NodeT>
  Subscriber(
    NodeT && node, const std::string & topic,
    const rclcpp::QoS & qos = rclcpp::SystemDefaultsQoS(),
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions())
  {
    subscribe(node, topic, qos, options);
  }
  template<class NodeT>
  Subscriber(
    NodeT && node, const std::string & topic, const rmw_qos_profile_t & qos,
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions())
  {
    subscribe(node, topic, qos, options);
  }
  virtual ~Subscriber() {unsubscribe();}

  template<class NodeT>
  void subscribe(
    NodeT && node, const std::string & topic,
    const rclcpp::QoS & qos = rclcpp::SystemDefaultsQoS(),
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions())
  {
    unsubscribe();
    if (topic.empty()) {return;}
    subscribe_ = [this, base = rclcpp::node_interfaces::get_node_base_interface(node), topic, qos,
        options]() {
        subscription_ = rclcpp::create_subscription<M>(
          base, topic, qos,
          [this](std::shared_ptr<const MessageType> message) {
            this->signalMessage(EventType(message));
          }, options);
      };
    subscribe_();
  }
  template<class NodeT>
  void subscribe(
    NodeT && node, const std::string & topic, const rmw_qos_profile_t & qos,
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions())
  {
    subscribe(
      node, topic, rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(qos), qos), options);
  }
  /// Subscribe again.
  void subscribe()
  {
    if (subscribe_) {subscribe_();}
  }
  void unsubscribe() {subscription_.reset();}

  std::string getTopic() const {return subscription_->get_topic_name();}
  typename rclcpp::Subscription<M>::SharedPtr getSubscriber() const {return subscription_;}

  // Required by Chain; a subscriber has no input.
  template<typename F>
  void connectInput(F &) {}
  void add(const EventType &) {}

private:
  std::function<void()> subscribe_;
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
};

}  // namespace message_filters
