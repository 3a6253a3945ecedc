// In a file of its own, so that only programs with custom executors link it.
#include "rclcpp/any_executable.hpp"

#include "rclcpp/client.hpp"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"
#include "rclcpp/executor.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp
{

namespace
{

using detail::Executable;
using detail::ExecutableKind;

/// Set the member of `any` for `one`; false if `one` is not ready.
bool set_if_ready(AnyExecutable & any, ExecutableKind kind, const std::shared_ptr<Executable> & one)
{
  switch (kind) {
    case ExecutableKind::kTimer:
      any.timer = std::static_pointer_cast<TimerBase>(one);
      any.data = any.timer->is_ready() ? any.timer->call() : nullptr;
      return any.data != nullptr;
    case ExecutableKind::kSubscription:
      any.subscription = std::static_pointer_cast<SubscriptionBase>(one);
      return any.subscription->is_ready();
    case ExecutableKind::kService:
      any.service = std::static_pointer_cast<ServiceBase>(one);
      return any.service->is_ready();
    case ExecutableKind::kClient:
      any.client = std::static_pointer_cast<ClientBase>(one);
      return any.client->is_ready();
    case ExecutableKind::kWaitable:
      any.waitable = std::static_pointer_cast<Waitable>(one);
      if (!any.waitable->look()) {return false;}
      any.data = any.waitable->take_data();
      return true;
  }
  return false;
}

void forget(AnyExecutable & any)
{
  any.timer.reset();
  any.subscription.reset();
  any.service.reset();
  any.client.reset();
  any.waitable.reset();
}

}  // namespace

bool Executor::get_next_ready_executable(AnyExecutable & any)
{
  for (bool all = false;; all = true) {
    while (!round_.empty()) {
      const Candidate candidate = round_.front();
      round_.pop_front();
      const auto group = candidate.group.lock();
      const auto one = candidate.executable.lock();
      if (!group || !one) {continue;}
      if (!group->can_be_taken_from()) {
        group->waited_for = true;
        continue;
      }
      if (set_if_ready(any, candidate.kind, one)) {
        const bool exclusive = group->type() == CallbackGroupType::MutuallyExclusive;
        group->can_be_taken_from() = !exclusive;
        any.callback_group = group;
        any.node_base = node_of(group);
        return true;
      }
      forget(any);
    }
    if (all) {return false;}
    round_ = candidates();
  }
}

node_interfaces::NodeBaseInterface::SharedPtr Executor::node_of(
  const CallbackGroup::SharedPtr & group) const
{
  for (const auto & node : nodes_) {
    const auto living = node.lock();
    if (living && living->callback_group_in_node(group)) {return living;}
  }
  return nullptr;
}

bool Executor::get_next_executable(AnyExecutable & any, std::chrono::nanoseconds timeout)
{
  detail::breathe();
  if (get_next_ready_executable(any)) {return true;}
  if (!may_go_on()) {return false;}
  wait_for_work(timeout);
  return may_go_on() && get_next_ready_executable(any);
}

void Executor::wait_for_work(std::chrono::nanoseconds timeout)
{
  wait(timeout.count() < 0 ? -1 : static_cast<double>(timeout.count()) / 1e6);
}

void Executor::execute_any_executable(AnyExecutable & any)
{
  if (any.timer) {execute_timer(any.timer, any.data);}
  if (any.subscription) {execute_subscription(any.subscription);}
  if (any.service) {execute_service(any.service);}
  if (any.client) {execute_client(any.client);}
  if (any.waitable) {any.waitable->execute(any.data);}
  if (any.callback_group) {any.callback_group->give_back();}
}

void Executor::execute_subscription(SubscriptionBase::SharedPtr subscription)
{
  subscription->execute_one();
}
void Executor::execute_timer(TimerBase::SharedPtr timer, const std::shared_ptr<void> & data)
{
  timer->execute_callback(data);
}
void Executor::execute_service(ServiceBase::SharedPtr service) {service->execute_one();}
void Executor::execute_client(ClientBase::SharedPtr client) {client->execute_one();}

}  // namespace rclcpp
