#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "rcl/wait.h"
#include "rclcpp/client.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/guard_condition.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/subscription_wait_set_mask.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/wait_result.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp
{

/// The common part of wait sets: the entities, and which of them are ready. No callbacks run.
class WaitSetBase
{
public:
  RCLCPP_DISABLE_COPY(WaitSetBase)

  struct SubscriptionEntry
  {
    SubscriptionEntry(
      SubscriptionBase::SharedPtr subscription = nullptr,  // NOLINT: implicit upstream
      const SubscriptionWaitSetMask & mask = {})
    : subscription(std::move(subscription)), mask(mask) {}
    template<class MessageT>
    SubscriptionEntry(std::shared_ptr<Subscription<MessageT>> subscription)  // NOLINT
    : subscription(std::move(subscription)) {}

    SubscriptionBase::SharedPtr subscription;
    SubscriptionWaitSetMask mask;
  };
  using Subscriptions = std::vector<SubscriptionEntry>;
  using GuardConditions = std::vector<GuardCondition::SharedPtr>;
  using Timers = std::vector<TimerBase::SharedPtr>;
  using Clients = std::vector<ClientBase::SharedPtr>;
  using Services = std::vector<ServiceBase::SharedPtr>;
  struct WaitableEntry
  {
    WaitableEntry(
      Waitable::SharedPtr waitable = nullptr,  // NOLINT: implicit upstream
      std::shared_ptr<void> associated_entity = nullptr) noexcept
    : waitable(std::move(waitable)), associated_entity(std::move(associated_entity)) {}

    Waitable::SharedPtr waitable;
    std::shared_ptr<void> associated_entity;
  };
  using Waitables = std::vector<WaitableEntry>;

  explicit WaitSetBase(
    const Subscriptions & subscriptions = {}, const GuardConditions & guard_conditions = {},
    const Timers & timers = {}, const Clients & clients = {}, const Services & services = {},
    const Waitables & waitables = {},
    Context::SharedPtr context = contexts::get_global_default_context());

  /// These throw std::runtime_error for entities that are already in a wait set.
  void add_subscription(
    SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask = {});
  void add_guard_condition(GuardCondition::SharedPtr guard_condition);
  void add_timer(TimerBase::SharedPtr timer);
  void add_client(ClientBase::SharedPtr client);
  void add_service(ServiceBase::SharedPtr service);
  /// Also keeps the owner of the waitable alive.
  void add_waitable(Waitable::SharedPtr waitable, std::shared_ptr<void> associated_entity = nullptr);
  /// These throw std::runtime_error for entities that are not in the wait set.
  void remove_subscription(
    SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask = {});
  void remove_guard_condition(GuardCondition::SharedPtr guard_condition);
  void remove_timer(TimerBase::SharedPtr timer);
  void remove_client(ClientBase::SharedPtr client);
  void remove_service(ServiceBase::SharedPtr service);
  void remove_waitable(Waitable::SharedPtr waitable);
  void prune_deleted_entities() {}

  const rcl_wait_set_t & get_rcl_wait_set() const {return ready_;}

  TimerBase::SharedPtr next_ready_timer();
  SubscriptionBase::SharedPtr next_ready_subscription();
  ServiceBase::SharedPtr next_ready_service();
  ClientBase::SharedPtr next_ready_client();
  Waitable::SharedPtr next_ready_waitable();

protected:
  WaitResultKind wait_for(double milliseconds);

private:
  /// Record what is ready; false if nothing is.
  bool look();

  Context::SharedPtr context_;
  std::vector<SubscriptionBase::SharedPtr> subscriptions_;
  GuardConditions guard_conditions_;
  Timers timers_;
  Clients clients_;
  Services services_;
  std::vector<Waitable::SharedPtr> waitables_;
  std::vector<std::shared_ptr<void>> associated_;  // with each of these
  rcl_wait_set_t ready_;
  std::vector<const void *> ready_waitables_;
};

/// Threads do not run in parallel, so every wait set is thread-safe, and the storage is the same.
namespace wait_set_policies
{

struct SequentialSynchronization {};
struct ThreadSafeSynchronization {};
struct DynamicStorage {};
template<
  std::size_t NumberOfSubscriptions, std::size_t NumberOfGuardConditions,
  std::size_t NumberOfTimers, std::size_t NumberOfClients, std::size_t NumberOfServices,
  std::size_t NumberOfWaitables>
struct StaticStorage {};

}  // namespace wait_set_policies

/// Waits until one of its entities is ready.
template<class SynchronizationPolicy, class StoragePolicy>
class WaitSetTemplate : public WaitSetBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WaitSetTemplate)

  using WaitSetBase::WaitSetBase;

  template<class Rep = std::int64_t, class Period = std::milli>
  WaitResult<WaitSetTemplate> wait(
    std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1))
  {
    const auto kind = wait_for(std::chrono::duration<double, std::milli>(time_to_wait).count());
    return WaitResult<WaitSetTemplate>(kind, *this);
  }
};

/// A wait set with a fixed number of entities.
template<
  class SynchronizationPolicy,
  std::size_t NumberOfSubscriptions, std::size_t NumberOfGuardConditions,
  std::size_t NumberOfTimers, std::size_t NumberOfClients, std::size_t NumberOfServices,
  std::size_t NumberOfWaitables>
class WaitSetTemplate<
    SynchronizationPolicy,
    wait_set_policies::StaticStorage<
      NumberOfSubscriptions, NumberOfGuardConditions, NumberOfTimers, NumberOfClients,
      NumberOfServices, NumberOfWaitables>>
  : public WaitSetTemplate<SynchronizationPolicy, wait_set_policies::DynamicStorage>
{
  using Dynamic = WaitSetTemplate<SynchronizationPolicy, wait_set_policies::DynamicStorage>;

public:
  RCLCPP_SMART_PTR_DEFINITIONS(WaitSetTemplate)

  explicit WaitSetTemplate(
    const std::array<WaitSetBase::SubscriptionEntry, NumberOfSubscriptions> & subscriptions = {},
    const std::array<GuardCondition::SharedPtr, NumberOfGuardConditions> & guard_conditions = {},
    const std::array<TimerBase::SharedPtr, NumberOfTimers> & timers = {},
    const std::array<ClientBase::SharedPtr, NumberOfClients> & clients = {},
    const std::array<ServiceBase::SharedPtr, NumberOfServices> & services = {},
    const std::array<WaitSetBase::WaitableEntry, NumberOfWaitables> & waitables = {},
    Context::SharedPtr context = contexts::get_global_default_context())
  : Dynamic(
      WaitSetBase::Subscriptions(subscriptions.begin(), subscriptions.end()),
      WaitSetBase::GuardConditions(guard_conditions.begin(), guard_conditions.end()),
      WaitSetBase::Timers(timers.begin(), timers.end()),
      WaitSetBase::Clients(clients.begin(), clients.end()),
      WaitSetBase::Services(services.begin(), services.end()),
      WaitSetBase::Waitables(waitables.begin(), waitables.end()), std::move(context)) {}
};

using WaitSet = WaitSetTemplate<
  wait_set_policies::SequentialSynchronization, wait_set_policies::DynamicStorage>;
using ThreadSafeWaitSet = WaitSetTemplate<
  wait_set_policies::ThreadSafeSynchronization, wait_set_policies::DynamicStorage>;
template<
  std::size_t NumberOfSubscriptions, std::size_t NumberOfGuardConditions,
  std::size_t NumberOfTimers, std::size_t NumberOfClients, std::size_t NumberOfServices,
  std::size_t NumberOfWaitables>
using StaticWaitSet = WaitSetTemplate<
  wait_set_policies::SequentialSynchronization,
  wait_set_policies::StaticStorage<
    NumberOfSubscriptions, NumberOfGuardConditions, NumberOfTimers, NumberOfClients,
    NumberOfServices, NumberOfWaitables>>;

}  // namespace rclcpp
