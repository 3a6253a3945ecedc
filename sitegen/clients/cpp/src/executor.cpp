#include "rclcpp/executor.hpp"

#include <algorithm>

#include "rclcpp/detail/host.h"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/receiver.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp
{

namespace
{

// A busy executor lets the event loop turn this often (ms): often enough for a Stop button, seldom
// enough to cost nothing.
constexpr double kBreath = 4;

/// The living ones of `entities`; those that are gone leave the list.
template<class T>
std::vector<std::shared_ptr<T>> lock(std::vector<std::weak_ptr<T>> & entities)
{
  std::vector<std::shared_ptr<T>> living;
  const auto gone = [&living](const std::weak_ptr<T> & entity) {
      auto locked = entity.lock();
      if (locked) {living.push_back(std::move(locked));}
      return entity.expired();
    };
  entities.erase(std::remove_if(entities.begin(), entities.end(), gone), entities.end());
  return living;
}

double in_milliseconds(std::chrono::nanoseconds duration)
{
  return static_cast<double>(duration.count()) / 1e6;
}

}  // namespace

void Executor::add_node(NodeBase node, bool) {nodes_.push_back(std::move(node));}

void Executor::remove_node(NodeBase node, bool)
{
  nodes_.erase(std::remove(nodes_.begin(), nodes_.end(), node), nodes_.end());
}

void Executor::cancel()
{
  canceled_ = true;
  ros_wake();
}

void Executor::spin()
{
  canceled_ = false;
  while (ok() && !canceled_) {
    if (execute_ready(false)) {
      breathe();
    } else {
      wait(-1);
    }
  }
}

void Executor::spin_some(std::chrono::nanoseconds)
{
  canceled_ = false;
  breathe();
  if (ok()) {execute_ready(false);}
}

void Executor::spin_all(std::chrono::nanoseconds max_duration)
{
  canceled_ = false;
  const double end = detail::now() + in_milliseconds(max_duration);
  breathe();
  while (ok() && execute_ready(false) && (max_duration.count() == 0 || detail::now() < end)) {
    breathe();
  }
}

void Executor::spin_once(std::chrono::nanoseconds timeout)
{
  canceled_ = false;
  breathe();
  if (!ok() || execute_ready(true)) {return;}
  wait(in_milliseconds(timeout));
  if (ok()) {execute_ready(true);}
}

FutureReturnCode Executor::spin_until(const std::function<bool()> & done, double timeout)
{
  canceled_ = false;
  const double end = detail::now() + timeout;
  while (!done()) {
    if (!ok() || canceled_) {return FutureReturnCode::INTERRUPTED;}
    const double left = end - detail::now();
    if (timeout >= 0 && left <= 0) {return FutureReturnCode::TIMEOUT;}
    if (execute_ready(true)) {
      breathe();
    } else {
      wait(timeout < 0 ? -1 : left);
    }
  }
  return FutureReturnCode::SUCCESS;
}

bool Executor::execute_events(bool only_first)
{
  const std::uint32_t events = ros_events();
  if (events == events_) {return false;}
  bool any = false;
  const auto nodes = nodes_;
  for (const auto & node : nodes) {
    for (const auto & publisher : lock(node->publishers)) {
      any = publisher->execute_events() || any;
      if (any && only_first) {return true;}
    }
    for (const auto & subscription : lock(node->subscriptions)) {
      any = subscription->execute_events() || any;
      if (any && only_first) {return true;}
    }
  }
  events_ = events;
  return any;
}

bool Executor::execute_ready(bool only_first)
{
  bool any = execute_events(only_first);
  const auto stop = [&]() {return !ok() || canceled_ || (any && only_first);};
  const auto nodes = nodes_;  // a callback may add or remove nodes
  for (const auto & node : nodes) {
    for (const auto & timer : lock(node->timers)) {
      if (stop()) {return any;}
      if (timer->is_ready()) {
        timer->execute();
        any = true;
      }
    }
    const auto execute_each = [&](auto & receivers) {
        for (const auto & receiver : lock(receivers)) {
          if (stop()) {return;}
          any = receiver->execute_one() || any;
        }
      };
    execute_each(node->subscriptions);
    execute_each(node->services);
    execute_each(node->clients);
    if (stop()) {return any;}
  }
  return any;
}

void Executor::wait(double timeout)
{
  for (const auto & node : nodes_) {
    for (const auto & timer : lock(node->timers)) {
      if (timer->is_canceled()) {continue;}
      const double left = std::max(0.0, in_milliseconds(timer->time_until_trigger()));
      if (timeout < 0 || left < timeout) {timeout = left;}
    }
  }
  detail::wait(timeout);
  last_wait_ = detail::now();
}

void Executor::breathe()
{
  if (detail::now() - last_wait_ < kBreath) {return;}
  detail::wait(0);
  last_wait_ = detail::now();
}

void spin(node_interfaces::NodeBaseInterface::SharedPtr node)
{
  executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
}

void spin(Node::SharedPtr node) {spin(node->get_node_base_interface());}

void spin_some(node_interfaces::NodeBaseInterface::SharedPtr node)
{
  executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_some();
}

void spin_some(Node::SharedPtr node) {spin_some(node->get_node_base_interface());}

}  // namespace rclcpp
