#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lifecycle_msgs/msg/transition_event.hpp"
#include "rclcpp/detail/any_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "rclcpp_lifecycle/node_interfaces/lifecycle_node_interface.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "rclcpp_lifecycle/transition.hpp"

namespace rclcpp_lifecycle
{

using rclcpp::PublisherOptionsWithAllocator;
using rclcpp::SubscriptionOptionsWithAllocator;

template<typename AllocatorT>
PublisherOptionsWithAllocator<AllocatorT> create_default_publisher_options()
{
  return {};
}
template<typename AllocatorT>
SubscriptionOptionsWithAllocator<AllocatorT> create_default_subscription_options()
{
  return {};
}

/// A node with a state that other nodes can change.
class LifecycleNode : public rclcpp::detail::AnyNode,
  public node_interfaces::LifecycleNodeInterface,
  public std::enable_shared_from_this<LifecycleNode>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecycleNode)

  using CallbackReturn = node_interfaces::LifecycleNodeInterface::CallbackReturn;
  using StateCallback = std::function<CallbackReturn (const State &)>;

  explicit LifecycleNode(
    const std::string & node_name, const rclcpp::NodeOptions & options = rclcpp::NodeOptions(),
    bool enable_communication_interface = true);
  LifecycleNode(
    const std::string & node_name, const std::string & name_space,
    const rclcpp::NodeOptions & options = rclcpp::NodeOptions(),
    bool enable_communication_interface = true);

  template<class MessageT, class AllocatorT = std::allocator<void>>
  std::shared_ptr<LifecyclePublisher<MessageT, AllocatorT>> create_publisher(
    const std::string & topic, const rclcpp::QoS & qos,
    const rclcpp::PublisherOptionsWithAllocator<AllocatorT> & options =
    rclcpp::PublisherOptionsWithAllocator<AllocatorT>())
  {
    auto publisher = std::make_shared<LifecyclePublisher<MessageT, AllocatorT>>(
      *get_node_base_interface(), extend_name(topic), qos, options);
    publisher->set_node_default(get_node_options().use_intra_process_comms());
    get_node_base_interface()->add(
      rclcpp::detail::ExecutableKind::kWaitable, publisher->events(), options.callback_group);
    add_managed_entity(publisher);
    return publisher;
  }

  const State & get_current_state() const {return current_;}
  std::vector<State> get_available_states() const;
  std::vector<Transition> get_available_transitions() const;
  std::vector<Transition> get_transition_graph() const;

  const State & trigger_transition(const Transition & transition)
  {
    return trigger_transition(transition.id());
  }
  const State & trigger_transition(std::uint8_t transition_id);
  const State & trigger_transition(const Transition & transition, CallbackReturn & code)
  {
    return trigger_transition(transition.id(), code);
  }
  const State & trigger_transition(std::uint8_t transition_id, CallbackReturn & code);
  const State & configure();
  const State & configure(CallbackReturn & code);
  const State & cleanup();
  const State & cleanup(CallbackReturn & code);
  const State & activate();
  const State & activate(CallbackReturn & code);
  const State & deactivate();
  const State & deactivate(CallbackReturn & code);
  const State & shutdown();
  const State & shutdown(CallbackReturn & code);

  bool register_on_configure(StateCallback callback);
  bool register_on_cleanup(StateCallback callback);
  bool register_on_shutdown(StateCallback callback);
  bool register_on_activate(StateCallback callback);
  bool register_on_deactivate(StateCallback callback);
  bool register_on_error(StateCallback callback);

  CallbackReturn on_activate(const State & previous_state) override;
  CallbackReturn on_deactivate(const State & previous_state) override;
  void add_managed_entity(std::weak_ptr<ManagedEntityInterface> entity);

private:
  void serve();
  void enter(const State & state, std::uint8_t transition, const std::string & label);
  CallbackReturn call(std::uint8_t transition, const State & previous);
  bool change(std::uint8_t transition, CallbackReturn & code);

  State current_;
  std::map<std::uint8_t, StateCallback> callbacks_;  // by the state that is gone through
  std::vector<std::weak_ptr<ManagedEntityInterface>> entities_;
  std::vector<std::shared_ptr<rclcpp::ServiceBase>> services_;
  std::shared_ptr<rclcpp::Publisher<lifecycle_msgs::msg::TransitionEvent>> events_;
};

}  // namespace rclcpp_lifecycle
