#include "rclcpp/executor.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"
#include "rclcpp/executors.hpp"

namespace rclcpp
{

namespace
{

double in_milliseconds(std::chrono::nanoseconds duration)
{
  return static_cast<double>(duration.count()) / 1e6;
}

/// Remove `item` and expired pointers from `list`; false if `item` was not in it.
template<class T>
bool remove(std::vector<std::weak_ptr<T>> & list, const std::shared_ptr<T> & item)
{
  bool found = false;
  const auto is_item = [&](const std::weak_ptr<T> & other) {
      found = found || other.lock() == item;
      return other.expired() || other.lock() == item;
    };
  list.erase(std::remove_if(list.begin(), list.end(), is_item), list.end());
  return found;
}

}  // namespace

std::string to_string(const FutureReturnCode & future_return_code)
{
  const char * names[] = {"SUCCESS", "INTERRUPTED", "TIMEOUT"};
  const auto number = static_cast<int>(future_return_code);
  return std::string(names[number]) + " (" + std::to_string(number) + ")";
}

Executor::Executor(const ExecutorOptions & options)
: context_(options.context)
{
}

Executor::~Executor()
{
  for (const auto & node : nodes_) {
    if (const auto living = node.lock()) {living->get_associated_with_executor_atomic() = false;}
  }
  for (const auto & group : groups_) {
    if (const auto living = group.lock()) {living->get_associated_with_executor_atomic() = false;}
  }
}

void Executor::add_node(NodeBase node, bool)
{
  if (node->get_associated_with_executor_atomic().exchange(true)) {
    throw std::runtime_error(
            std::string("Node '") + node->get_fully_qualified_name() +
            "' has already been added to an executor.");
  }
  nodes_.push_back(node);
  detail::wake();
}

void Executor::remove_node(NodeBase node, bool)
{
  if (!node->get_associated_with_executor_atomic()) {
    throw std::runtime_error("Node needs to be associated with an executor.");
  }
  if (!remove(nodes_, node)) {
    throw std::runtime_error("Node needs to be associated with this executor.");
  }
  node->get_associated_with_executor_atomic() = false;
}

void Executor::add_callback_group(CallbackGroup::SharedPtr group, NodeBase, bool)
{
  if (group->get_associated_with_executor_atomic().exchange(true)) {
    throw std::runtime_error("Callback group has already been added to an executor.");
  }
  groups_.push_back(group);
  detail::wake();
}

void Executor::remove_callback_group(CallbackGroup::SharedPtr group, bool)
{
  if (!remove(groups_, group)) {
    throw std::runtime_error("Callback group needs to be associated with executor.");
  }
  group->get_associated_with_executor_atomic() = false;
}

std::vector<CallbackGroup::WeakPtr> Executor::get_all_callback_groups()
{
  const auto all = groups();
  return {all.begin(), all.end()};
}

std::vector<CallbackGroup::WeakPtr> Executor::get_manually_added_callback_groups()
{
  return groups_;
}

std::vector<CallbackGroup::WeakPtr> Executor::get_automatically_added_callback_groups_from_nodes()
{
  std::vector<CallbackGroup::WeakPtr> found;
  for (const auto & node : nodes_) {
    const auto living = node.lock();
    if (!living) {continue;}
    living->for_each_callback_group([&found](const CallbackGroup::SharedPtr & group) {
        const bool taken = group->get_associated_with_executor_atomic();
        if (group->automatically_add_to_executor_with_node() && !taken) {found.push_back(group);}
      });
  }
  return found;
}

std::vector<CallbackGroup::SharedPtr> Executor::groups()
{
  std::vector<CallbackGroup::SharedPtr> all;
  auto found = get_automatically_added_callback_groups_from_nodes();
  found.insert(found.end(), groups_.begin(), groups_.end());
  for (const auto & group : found) {
    if (auto living = group.lock()) {all.push_back(std::move(living));}
  }
  return all;
}

std::deque<Executor::Candidate> Executor::candidates()
{
  std::deque<Candidate> all;
  const auto groups = this->groups();
  for (int kind = 0; kind < detail::kExecutableKinds; ++kind) {
    for (const auto & group : groups) {
      for (const auto & one : group->living(detail::ExecutableKind(kind))) {
        all.push_back({detail::ExecutableKind(kind), group, one});
      }
    }
  }
  return all;
}

bool Executor::execute(const Candidate & candidate)
{
  const auto group = candidate.group.lock();
  const auto executable = candidate.executable.lock();
  if (!group || !executable) {return false;}
  if (!group->can_be_taken_from()) {
    group->waited_for = true;
    return false;
  }
  const bool exclusive = group->type() == CallbackGroupType::MutuallyExclusive;
  if (!exclusive) {return executable->execute_one();}
  // Also if the callback throws.
  struct Taken
  {
    explicit Taken(CallbackGroup & group)
    : group_(group) {group_.can_be_taken_from() = false;}
    ~Taken() {group_.give_back();}
    CallbackGroup & group_;
  } taken(*group);
  return executable->execute_one();
}

bool Executor::execute_next()
{
  for (bool all = false;; all = true) {
    while (!round_.empty()) {
      const Candidate candidate = round_.front();
      round_.pop_front();
      if (execute(candidate)) {return true;}
      if (!may_go_on()) {return false;}
    }
    if (all) {return false;}
    round_ = candidates();
  }
}

bool Executor::may_go_on() const {return context_->is_valid() && spinning;}

void Executor::wait(double timeout)
{
  for (const auto & group : groups()) {
    for (const auto & timer : group->living(detail::ExecutableKind::kTimer)) {
      const std::int64_t left = timer->time_left();
      if (left == INT64_MAX) {continue;}
      const double milliseconds = static_cast<double>(std::max<std::int64_t>(left, 0)) / 1e6;
      // Entities of a busy callback group are checked again when the group is free.
      const bool ready = milliseconds <= 0 && !group->can_be_taken_from();
      if (!ready && (timeout < 0 || milliseconds < timeout)) {timeout = milliseconds;}
    }
  }
  detail::wait(timeout);
}

void Executor::work()
{
  while (may_go_on()) {
    if (execute_next()) {
      detail::breathe();
    } else if (may_go_on()) {
      wait(-1);
    }
  }
}

void Executor::begin_spinning(const char * name)
{
  if (spinning.exchange(true)) {
    throw std::runtime_error(std::string(name) + "() called while already spinning");
  }
}

void Executor::end_spinning()
{
  spinning = false;
  round_.clear();
}

void Executor::cancel()
{
  spinning = false;
  detail::wake();
}

void Executor::spin()
{
  begin_spinning("spin");
  work();
  end_spinning();
}

void Executor::spin_some(std::chrono::nanoseconds max_duration)
{
  begin_spinning("spin_some");
  detail::breathe();
  const double end = detail::now() + in_milliseconds(max_duration);
  for (const auto & candidate : candidates()) {
    if (!may_go_on() || (max_duration.count() > 0 && detail::now() >= end)) {break;}
    execute(candidate);
  }
  end_spinning();
}

void Executor::spin_all(std::chrono::nanoseconds max_duration)
{
  if (max_duration.count() < 0) {
    throw std::invalid_argument("max_duration must be greater than or equal to 0");
  }
  begin_spinning("spin_all");
  const double end = detail::now() + in_milliseconds(max_duration);
  detail::breathe();
  while (may_go_on() && execute_next() && (max_duration.count() == 0 || detail::now() < end)) {
    detail::breathe();
  }
  end_spinning();
}

void Executor::spin_once(std::chrono::nanoseconds timeout)
{
  begin_spinning("spin_once");
  spin_once_impl(timeout);
  end_spinning();
}

void Executor::spin_once_impl(std::chrono::nanoseconds timeout)
{
  detail::breathe();
  const double limit = in_milliseconds(timeout);
  const double end = detail::now() + limit;
  while (may_go_on() && !execute_next()) {
    const double left = end - detail::now();
    if (!may_go_on() || (limit >= 0 && left <= 0)) {break;}
    wait(limit < 0 ? -1 : left);
  }
}

void Executor::spin_node_some(NodeBase node)
{
  add_node(node, false);
  spin_some();
  remove_node(node, false);
}

void Executor::spin_node_all(NodeBase node, std::chrono::nanoseconds max_duration)
{
  add_node(node, false);
  spin_all(max_duration);
  remove_node(node, false);
}

FutureReturnCode Executor::spin_until(const std::function<bool()> & done, double timeout)
{
  if (done()) {return FutureReturnCode::SUCCESS;}
  begin_spinning("spin_until_future_complete");
  const double end = detail::now() + timeout;
  auto code = FutureReturnCode::INTERRUPTED;
  while (may_go_on()) {
    if (execute_next()) {
      detail::breathe();
    } else {
      wait(timeout < 0 ? -1 : std::max(0.0, end - detail::now()));
    }
    if (done()) {
      code = FutureReturnCode::SUCCESS;
      break;
    }
    if (timeout >= 0 && detail::now() >= end) {
      code = FutureReturnCode::TIMEOUT;
      break;
    }
  }
  end_spinning();
  return code;
}

void spin(node_interfaces::NodeBaseInterface::SharedPtr node)
{
  ExecutorOptions options;
  options.context = node->get_context();
  executors::SingleThreadedExecutor executor(options);
  executor.add_node(node);
  executor.spin();
  executor.remove_node(node);
}

void spin_some(node_interfaces::NodeBaseInterface::SharedPtr node)
{
  ExecutorOptions options;
  options.context = node->get_context();
  executors::SingleThreadedExecutor executor(options);
  executor.spin_node_some(node);
}

void spin_all(
  node_interfaces::NodeBaseInterface::SharedPtr node, std::chrono::nanoseconds max_duration)
{
  ExecutorOptions options;
  options.context = node->get_context();
  executors::SingleThreadedExecutor executor(options);
  executor.spin_node_all(node, max_duration);
}

}  // namespace rclcpp
