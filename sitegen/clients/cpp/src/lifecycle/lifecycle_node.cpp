#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include <algorithm>
#include <utility>

#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_available_states.hpp"
#include "lifecycle_msgs/srv/get_available_transitions.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"

namespace rclcpp_lifecycle
{

namespace
{

using S = lifecycle_msgs::msg::State;
using T = lifecycle_msgs::msg::Transition;
namespace srv = lifecycle_msgs::srv;

const std::pair<std::uint8_t, const char *> kStates[] = {
  {S::PRIMARY_STATE_UNKNOWN, "unknown"}, {S::PRIMARY_STATE_UNCONFIGURED, "unconfigured"},
  {S::PRIMARY_STATE_INACTIVE, "inactive"}, {S::PRIMARY_STATE_ACTIVE, "active"},
  {S::PRIMARY_STATE_FINALIZED, "finalized"}, {S::TRANSITION_STATE_CONFIGURING, "configuring"},
  {S::TRANSITION_STATE_CLEANINGUP, "cleaningup"},
  {S::TRANSITION_STATE_SHUTTINGDOWN, "shuttingdown"},
  {S::TRANSITION_STATE_ACTIVATING, "activating"},
  {S::TRANSITION_STATE_DEACTIVATING, "deactivating"},
  {S::TRANSITION_STATE_ERRORPROCESSING, "errorprocessing"}};

State state(std::uint8_t id)
{
  for (const auto & [known, label] : kStates) {
    if (known == id) {return State(id, label);}
  }
  return State();
}

/// A transition that can be requested in state `from`: through a transition state to another state.
struct Edge
{
  std::uint8_t id;
  const char * label;
  std::uint8_t from;
  std::uint8_t through;
  std::uint8_t to;
};

const Edge kEdges[] = {
  {T::TRANSITION_CONFIGURE, "configure", S::PRIMARY_STATE_UNCONFIGURED,
    S::TRANSITION_STATE_CONFIGURING, S::PRIMARY_STATE_INACTIVE},
  {T::TRANSITION_CLEANUP, "cleanup", S::PRIMARY_STATE_INACTIVE,
    S::TRANSITION_STATE_CLEANINGUP, S::PRIMARY_STATE_UNCONFIGURED},
  {T::TRANSITION_ACTIVATE, "activate", S::PRIMARY_STATE_INACTIVE,
    S::TRANSITION_STATE_ACTIVATING, S::PRIMARY_STATE_ACTIVE},
  {T::TRANSITION_DEACTIVATE, "deactivate", S::PRIMARY_STATE_ACTIVE,
    S::TRANSITION_STATE_DEACTIVATING, S::PRIMARY_STATE_INACTIVE},
  {T::TRANSITION_UNCONFIGURED_SHUTDOWN, "shutdown", S::PRIMARY_STATE_UNCONFIGURED,
    S::TRANSITION_STATE_SHUTTINGDOWN, S::PRIMARY_STATE_FINALIZED},
  {T::TRANSITION_INACTIVE_SHUTDOWN, "shutdown", S::PRIMARY_STATE_INACTIVE,
    S::TRANSITION_STATE_SHUTTINGDOWN, S::PRIMARY_STATE_FINALIZED},
  {T::TRANSITION_ACTIVE_SHUTDOWN, "shutdown", S::PRIMARY_STATE_ACTIVE,
    S::TRANSITION_STATE_SHUTTINGDOWN, S::PRIMARY_STATE_FINALIZED}};

Transition transition(const Edge & edge)
{
  return Transition(edge.id, edge.label, state(edge.from), state(edge.through));
}

template<class MessageT>
MessageT message(const State & from)
{
  MessageT to;
  to.id = from.id();
  to.label = from.label();
  return to;
}

lifecycle_msgs::msg::TransitionDescription description(const Edge & edge)
{
  lifecycle_msgs::msg::TransitionDescription to;
  to.transition.id = edge.id;
  to.transition.label = edge.label;
  to.start_state = message<S>(state(edge.from));
  to.goal_state = message<S>(state(edge.through));
  return to;
}

}  // namespace

LifecycleNode::LifecycleNode(
  const std::string & node_name, const rclcpp::NodeOptions & options, bool communicate)
: LifecycleNode(node_name, "", options, communicate)
{
}

LifecycleNode::LifecycleNode(
  const std::string & node_name, const std::string & name_space,
  const rclcpp::NodeOptions & options, bool communicate)
: AnyNode(node_name, name_space, options), current_(state(S::PRIMARY_STATE_UNCONFIGURED))
{
  if (communicate) {serve();}
}

void LifecycleNode::serve()
{
  events_ = AnyNode::create_publisher<lifecycle_msgs::msg::TransitionEvent>(
    "~/transition_event", 10);
  services_.push_back(create_service<srv::ChangeState>(
      "~/change_state", [this](
        srv::ChangeState::Request::SharedPtr request,
        srv::ChangeState::Response::SharedPtr response) {
        std::uint8_t id = request->transition.id;
        const auto & label = request->transition.label;
        for (const auto & edge : kEdges) {
          if (!label.empty() && label == edge.label && edge.from == current_.id()) {id = edge.id;}
        }
        CallbackReturn code;
        response->success = change(id, code) && code == CallbackReturn::SUCCESS;
      }));
  services_.push_back(create_service<srv::GetState>(
      "~/get_state", [this](
        srv::GetState::Request::SharedPtr, srv::GetState::Response::SharedPtr response) {
        response->current_state = message<S>(current_);
      }));
  services_.push_back(create_service<srv::GetAvailableStates>(
      "~/get_available_states", [this](
        srv::GetAvailableStates::Request::SharedPtr,
        srv::GetAvailableStates::Response::SharedPtr response) {
        for (const auto & one : get_available_states()) {
          response->available_states.push_back(message<S>(one));
        }
      }));
  const auto list = [this](const char * name, bool all) {
      services_.push_back(create_service<srv::GetAvailableTransitions>(
          name, [this, all](
            srv::GetAvailableTransitions::Request::SharedPtr,
            srv::GetAvailableTransitions::Response::SharedPtr response) {
            for (const auto & edge : kEdges) {
              if (!all && edge.from != current_.id()) {continue;}
              response->available_transitions.push_back(description(edge));
            }
          }));
    };
  list("~/get_available_transitions", false);
  list("~/get_transition_graph", true);
}

std::vector<State> LifecycleNode::get_available_states() const
{
  std::vector<State> all;
  for (const auto & [id, label] : kStates) {all.emplace_back(id, label);}
  return all;
}

std::vector<Transition> LifecycleNode::get_available_transitions() const
{
  std::vector<Transition> found;
  for (const auto & edge : kEdges) {
    if (edge.from == current_.id()) {found.push_back(transition(edge));}
  }
  return found;
}

std::vector<Transition> LifecycleNode::get_transition_graph() const
{
  std::vector<Transition> all;
  for (const auto & edge : kEdges) {all.push_back(transition(edge));}
  return all;
}

void LifecycleNode::enter(
  const State & next, std::uint8_t transition, const std::string & label)
{
  if (events_) {
    lifecycle_msgs::msg::TransitionEvent event;
    event.timestamp = static_cast<std::uint64_t>(now().nanoseconds());
    event.transition.id = transition;
    event.transition.label = label;
    event.start_state = message<S>(current_);
    event.goal_state = message<S>(next);
    events_->publish(event);
  }
  current_ = next;
}

LifecycleNode::CallbackReturn LifecycleNode::call(std::uint8_t through, const State & previous)
{
  try {
    const auto registered = callbacks_.find(through);
    if (registered != callbacks_.end()) {return registered->second(previous);}
    switch (through) {
      case S::TRANSITION_STATE_CONFIGURING: return on_configure(previous);
      case S::TRANSITION_STATE_CLEANINGUP: return on_cleanup(previous);
      case S::TRANSITION_STATE_SHUTTINGDOWN: return on_shutdown(previous);
      case S::TRANSITION_STATE_ACTIVATING: return on_activate(previous);
      case S::TRANSITION_STATE_DEACTIVATING: return on_deactivate(previous);
      default: return on_error(previous);
    }
  } catch (const std::exception & error) {
    RCLCPP_ERROR(get_logger(), "Caught exception in callback for transition %d", through);
    RCLCPP_ERROR(get_logger(), "Original error: %s", error.what());
    return CallbackReturn::ERROR;
  }
}

bool LifecycleNode::change(std::uint8_t id, CallbackReturn & code)
{
  const auto edge = std::find_if(
    std::begin(kEdges), std::end(kEdges),
    [&](const Edge & one) {return one.id == id && one.from == current_.id();});
  if (edge == std::end(kEdges)) {
    const std::string label = current_.label();
    RCLCPP_WARN(
      rclcpp::get_logger("rcl_lifecycle"), "No transition matching %d found for current state %s",
      id, label.c_str());
    RCLCPP_ERROR(
      get_logger(), "Unable to start transition %u from current state %s: %s", id, label.c_str(),
      "Transition is not registered.");
    code = CallbackReturn::ERROR;
    return false;
  }
  const State initial = current_;
  enter(state(edge->through), id, edge->label);
  code = call(edge->through, initial);
  // A shutdown that failed ends all the same.
  const bool failed = code == CallbackReturn::FAILURE &&
    edge->through != S::TRANSITION_STATE_SHUTTINGDOWN;
  if (code != CallbackReturn::ERROR) {
    const char * label = failed ? "transition_failure" : "transition_success";
    enter(failed ? initial : state(edge->to), id, label);
    return true;
  }
  enter(state(S::TRANSITION_STATE_ERRORPROCESSING), id, "transition_error");
  RCLCPP_WARN(get_logger(), "Error occurred while doing error handling.");
  const bool recovered = call(S::TRANSITION_STATE_ERRORPROCESSING, initial) ==
    CallbackReturn::SUCCESS;
  const auto last = recovered ? S::PRIMARY_STATE_UNCONFIGURED : S::PRIMARY_STATE_FINALIZED;
  enter(state(last), id, recovered ? "transition_success" : "transition_failure");
  return true;
}

const State & LifecycleNode::trigger_transition(std::uint8_t id)
{
  CallbackReturn code;
  return trigger_transition(id, code);
}

const State & LifecycleNode::trigger_transition(std::uint8_t id, CallbackReturn & code)
{
  change(id, code);
  return current_;
}

const State & LifecycleNode::configure() {return trigger_transition(T::TRANSITION_CONFIGURE);}
const State & LifecycleNode::configure(CallbackReturn & code)
{
  return trigger_transition(T::TRANSITION_CONFIGURE, code);
}
const State & LifecycleNode::cleanup() {return trigger_transition(T::TRANSITION_CLEANUP);}
const State & LifecycleNode::cleanup(CallbackReturn & code)
{
  return trigger_transition(T::TRANSITION_CLEANUP, code);
}
const State & LifecycleNode::activate() {return trigger_transition(T::TRANSITION_ACTIVATE);}
const State & LifecycleNode::activate(CallbackReturn & code)
{
  return trigger_transition(T::TRANSITION_ACTIVATE, code);
}
const State & LifecycleNode::deactivate() {return trigger_transition(T::TRANSITION_DEACTIVATE);}
const State & LifecycleNode::deactivate(CallbackReturn & code)
{
  return trigger_transition(T::TRANSITION_DEACTIVATE, code);
}
const State & LifecycleNode::shutdown()
{
  CallbackReturn code;
  return shutdown(code);
}
const State & LifecycleNode::shutdown(CallbackReturn & code)
{
  for (const auto & edge : kEdges) {
    if (edge.from == current_.id() && edge.through == S::TRANSITION_STATE_SHUTTINGDOWN) {
      return trigger_transition(edge.id, code);
    }
  }
  return trigger_transition(T::TRANSITION_UNCONFIGURED_SHUTDOWN, code);
}

bool LifecycleNode::register_on_configure(StateCallback callback)
{
  callbacks_[S::TRANSITION_STATE_CONFIGURING] = std::move(callback);
  return true;
}
bool LifecycleNode::register_on_cleanup(StateCallback callback)
{
  callbacks_[S::TRANSITION_STATE_CLEANINGUP] = std::move(callback);
  return true;
}
bool LifecycleNode::register_on_shutdown(StateCallback callback)
{
  callbacks_[S::TRANSITION_STATE_SHUTTINGDOWN] = std::move(callback);
  return true;
}
bool LifecycleNode::register_on_activate(StateCallback callback)
{
  callbacks_[S::TRANSITION_STATE_ACTIVATING] = std::move(callback);
  return true;
}
bool LifecycleNode::register_on_deactivate(StateCallback callback)
{
  callbacks_[S::TRANSITION_STATE_DEACTIVATING] = std::move(callback);
  return true;
}
bool LifecycleNode::register_on_error(StateCallback callback)
{
  callbacks_[S::TRANSITION_STATE_ERRORPROCESSING] = std::move(callback);
  return true;
}

LifecycleNode::CallbackReturn LifecycleNode::on_activate(const State &)
{
  for (const auto & entity : entities_) {
    if (const auto living = entity.lock()) {living->on_activate();}
  }
  return CallbackReturn::SUCCESS;
}

LifecycleNode::CallbackReturn LifecycleNode::on_deactivate(const State &)
{
  for (const auto & entity : entities_) {
    if (const auto living = entity.lock()) {living->on_deactivate();}
  }
  return CallbackReturn::SUCCESS;
}

void LifecycleNode::add_managed_entity(std::weak_ptr<ManagedEntityInterface> entity)
{
  entities_.push_back(std::move(entity));
}

}  // namespace rclcpp_lifecycle
