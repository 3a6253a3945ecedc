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

/// A subscriber of messages of any type, as a base of programs that keep several. Humble names the
/// type of the node as a parameter, and Rolling has no parameter, so it is a pack that may be empty.
template<class ... NodeTs>
class SubscriberBase
{
public:
  virtual ~SubscriberBase() = default;

  /// `node` is a node, or a pointer to one. An empty topic only unsubscribes.
  template<class NodeT>
  void subscribe(
    NodeT && node, const std::string & topic,
    const rclcpp::QoS & qos = rclcpp::SystemDefaultsQoS(),
    const rclcpp::SubscriptionOptions & options = rclcpp::SubscriptionOptions())
  {
    unsubscribe();
    if (topic.empty()) {return;}
    subscribe_to(
      rclcpp::node_interfaces::get_node_base_interface(node), topic, qos, options);
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
  virtual void subscribe() = 0;
  virtual void unsubscribe() = 0;

protected:
  virtual void subscribe_to(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, const std::string & topic,
    const rclcpp::QoS & qos, const rclcpp::SubscriptionOptions & options) = 0;
};
template<class ... NodeTs>
using SubscriberBasePtr = std::shared_ptr<SubscriberBase<NodeTs...>>;

/// A filter that receives the messages of a topic.
template<class M, class ... NodeTs>
class Subscriber
  : public SubscriberBase<NodeTs...>, public SimpleFilter<rclcpp::detail::custom_type<M>>
{
public:
  using SubscriberBase<NodeTs...>::subscribe;
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
  ~Subscriber() override {unsubscribe();}

  void subscribe() override
  {
    if (subscribe_) {subscribe_();}
  }
  void unsubscribe() override {subscription_.reset();}

  std::string getTopic() const {return subscription_->get_topic_name();}
  typename rclcpp::Subscription<M>::SharedPtr getSubscriber() const {return subscription_;}

  // Required by Chain; a subscriber has no input.
  template<typename F>
  void connectInput(F &) {}
  void add(const EventType &) {}

protected:
  void subscribe_to(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node, const std::string & topic,
    const rclcpp::QoS & qos, const rclcpp::SubscriptionOptions & options) override
  {
    subscribe_ = [this, node, topic, qos, options]() {
        subscription_ = rclcpp::create_subscription<M>(
          node, topic, qos,
          [this](std::shared_ptr<const MessageType> message) {
            this->signalMessage(EventType(message));
          }, options);
      };
    subscribe_();
  }

private:
  std::function<void()> subscribe_;
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
};

}  // namespace message_filters
