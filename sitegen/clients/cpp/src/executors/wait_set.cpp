#include "rclcpp/wait_set.hpp"

#include <algorithm>
#include <stdexcept>

#include "rclcpp/detail/platform.hpp"

namespace rclcpp
{

namespace
{

template<class T>
void add(std::vector<std::shared_ptr<T>> & list, std::shared_ptr<T> item, const char * what)
{
  if (!item) {throw std::invalid_argument(std::string(what) + " is nullptr");}
  if (std::find(list.begin(), list.end(), item) != list.end()) {
    throw std::runtime_error(std::string(what) + " already associated with a wait set");
  }
  list.push_back(std::move(item));
}

template<class T>
void remove(std::vector<std::shared_ptr<T>> & list, const std::shared_ptr<T> & item, const char * what)
{
  const auto found = std::find(list.begin(), list.end(), item);
  if (found == list.end()) {throw std::runtime_error(std::string(what) + " not in wait set");}
  list.erase(found);
}

/// Record which entities of `list` are ready; false if none is.
template<class T, class ReadyT>
bool note(
  const std::vector<std::shared_ptr<T>> & list, std::vector<const void *> & noted, ReadyT ready)
{
  noted.clear();
  bool any = false;
  for (const auto & item : list) {
    const bool is = ready(*item);
    noted.push_back(is ? item.get() : nullptr);
    any = any || is;
  }
  return any;
}

/// Take the first entity of `list` that is recorded as ready.
template<class T>
std::shared_ptr<T> next(
  const std::vector<std::shared_ptr<T>> & list, std::vector<const void *> & noted)
{
  for (std::size_t i = 0; i < std::min(list.size(), noted.size()); ++i) {
    if (noted[i]) {
      noted[i] = nullptr;
      return list[i];
    }
  }
  return nullptr;
}

}  // namespace

WaitSetBase::WaitSetBase(
  const Subscriptions & subscriptions, const GuardConditions & guard_conditions,
  const Timers & timers, const Clients & clients, const Services & services,
  const Waitables & waitables,
  Context::SharedPtr context)
: context_(std::move(context)), guard_conditions_(guard_conditions), timers_(timers),
  clients_(clients), services_(services)
{
  for (const auto & entry : subscriptions) {add_subscription(entry.subscription, entry.mask);}
  for (const auto & entry : waitables) {add_waitable(entry.waitable, entry.associated_entity);}
}

void WaitSetBase::add_subscription(
  SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask)
{
  if (mask.include_subscription) {add(subscriptions_, subscription, "subscription");}
  if (mask.include_events) {add_waitable(subscription->events(), subscription);}
}
void WaitSetBase::add_guard_condition(GuardCondition::SharedPtr guard_condition)
{
  add(guard_conditions_, std::move(guard_condition), "guard condition");
}
void WaitSetBase::add_timer(TimerBase::SharedPtr timer) {add(timers_, std::move(timer), "timer");}
void WaitSetBase::add_client(ClientBase::SharedPtr client) {add(clients_, std::move(client), "client");}
void WaitSetBase::add_service(ServiceBase::SharedPtr service)
{
  add(services_, std::move(service), "service");
}
void WaitSetBase::remove_subscription(
  SubscriptionBase::SharedPtr subscription, SubscriptionWaitSetMask mask)
{
  if (mask.include_subscription) {remove(subscriptions_, subscription, "subscription");}
  if (mask.include_events) {remove_waitable(subscription->events());}
}
void WaitSetBase::remove_guard_condition(GuardCondition::SharedPtr guard_condition)
{
  remove(guard_conditions_, guard_condition, "guard condition");
}
void WaitSetBase::remove_timer(TimerBase::SharedPtr timer) {remove(timers_, timer, "timer");}
void WaitSetBase::remove_client(ClientBase::SharedPtr client) {remove(clients_, client, "client");}
void WaitSetBase::remove_service(ServiceBase::SharedPtr service)
{
  remove(services_, service, "service");
}

void WaitSetBase::add_waitable(
  Waitable::SharedPtr waitable, std::shared_ptr<void> associated_entity)
{
  add(waitables_, std::move(waitable), "waitable");
  associated_.push_back(std::move(associated_entity));
}
void WaitSetBase::remove_waitable(Waitable::SharedPtr waitable)
{
  const auto found = std::find(waitables_.begin(), waitables_.end(), waitable);
  const auto index = found - waitables_.begin();
  remove(waitables_, waitable, "waitable");
  associated_.erase(associated_.begin() + index);
}

bool WaitSetBase::look()
{
  const auto has_message = [](const detail::Receiver & receiver) {return receiver.is_ready();};
  // Check all of them, so that each is recorded.
  const bool found[] = {
    note(subscriptions_, ready_.subscriptions, has_message),
    note(clients_, ready_.clients, has_message),
    note(services_, ready_.services, has_message),
    note(timers_, ready_.timers, [](const TimerBase & timer) {return timer.is_ready();}),
    note(
      guard_conditions_, ready_.guard_conditions,
      [](GuardCondition & condition) {return condition.take();}),
    note(waitables_, ready_waitables_, [](Waitable & waitable) {return waitable.look();})};
  ready_.size_of_subscriptions = ready_.subscriptions.size();
  ready_.size_of_guard_conditions = ready_.guard_conditions.size();
  ready_.size_of_timers = ready_.timers.size();
  ready_.size_of_clients = ready_.clients.size();
  ready_.size_of_services = ready_.services.size();
  return std::find(std::begin(found), std::end(found), true) != std::end(found);
}

WaitResultKind WaitSetBase::wait_for(double milliseconds)
{
  const bool empty = subscriptions_.empty() && clients_.empty() && services_.empty() &&
    timers_.empty() && guard_conditions_.empty() && waitables_.empty();
  if (empty) {return WaitResultKind::Empty;}
  const double end = detail::now() + milliseconds;
  detail::breathe();
  while (true) {
    if (look()) {return WaitResultKind::Ready;}
    double left = milliseconds < 0 ? -1 : end - detail::now();
    // Upstream, a wait continues after a shutdown until it times out. Here, nothing more can arrive.
    if (!context_->is_valid() || (milliseconds >= 0 && left <= 0)) {return WaitResultKind::Timeout;}
    for (const auto & timer : timers_) {
      const std::int64_t until = timer->time_left();
      if (until == INT64_MAX) {continue;}
      const double due = std::max(0.0, static_cast<double>(until) / 1e6);
      left = left < 0 ? due : std::min(left, due);
    }
    detail::wait(left);
  }
}

TimerBase::SharedPtr WaitSetBase::next_ready_timer() {return next(timers_, ready_.timers);}
SubscriptionBase::SharedPtr WaitSetBase::next_ready_subscription()
{
  return next(subscriptions_, ready_.subscriptions);
}
ServiceBase::SharedPtr WaitSetBase::next_ready_service() {return next(services_, ready_.services);}
ClientBase::SharedPtr WaitSetBase::next_ready_client() {return next(clients_, ready_.clients);}
Waitable::SharedPtr WaitSetBase::next_ready_waitable() {return next(waitables_, ready_waitables_);}

}  // namespace rclcpp
