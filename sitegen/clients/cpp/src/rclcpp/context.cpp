#include "rclcpp/context.hpp"

#include <algorithm>
#include <utility>

#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/detail/platform.hpp"
#include "rclcpp/detail/stacks.hpp"
#include "rclcpp/guard_condition.hpp"

namespace rclcpp
{

namespace
{

bool remove(
  std::vector<std::shared_ptr<std::function<void()>>> & callbacks,
  const ShutdownCallbackHandle & handle)
{
  const auto found = std::find(callbacks.begin(), callbacks.end(), handle.callback.lock());
  if (found == callbacks.end()) {return false;}
  callbacks.erase(found);
  return true;
}

std::vector<std::function<void()>> copies(
  const std::vector<std::shared_ptr<std::function<void()>>> & callbacks)
{
  std::vector<std::function<void()>> found;
  for (const auto & callback : callbacks) {found.push_back(*callback);}
  return found;
}

}  // namespace

void Context::init(int argc, char const * const * argv, const InitOptions & init_options)
{
  if (valid_) {throw ContextAlreadyInitialized();}
  arguments_ = detail::parse_arguments(argc, argv);
  options_ = init_options;
  reason_.clear();
  valid_ = true;
}

bool Context::shutdown(const std::string & reason)
{
  if (!valid_) {return false;}
  for (const auto & callback : Callbacks(pre_shutdown_)) {(*callback)();}
  valid_ = false;
  reason_ = reason;
  for (const auto & callback : Callbacks(on_shutdown_)) {(*callback)();}
  interrupt_all_sleep_for();
  return true;
}

Context::OnShutdownCallback Context::on_shutdown(OnShutdownCallback callback)
{
  add_on_shutdown_callback(callback);
  return callback;
}

OnShutdownCallbackHandle Context::add_on_shutdown_callback(OnShutdownCallback callback)
{
  on_shutdown_.push_back(std::make_shared<OnShutdownCallback>(std::move(callback)));
  return {on_shutdown_.back()};
}

bool Context::remove_on_shutdown_callback(const OnShutdownCallbackHandle & handle)
{
  return remove(on_shutdown_, handle);
}

PreShutdownCallbackHandle Context::add_pre_shutdown_callback(PreShutdownCallback callback)
{
  pre_shutdown_.push_back(std::make_shared<PreShutdownCallback>(std::move(callback)));
  return {pre_shutdown_.back()};
}

bool Context::remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle)
{
  return remove(pre_shutdown_, handle);
}

std::vector<Context::OnShutdownCallback> Context::get_on_shutdown_callbacks() const
{
  return copies(on_shutdown_);
}

std::vector<Context::PreShutdownCallback> Context::get_pre_shutdown_callbacks() const
{
  return copies(pre_shutdown_);
}

bool Context::sleep_for(const std::chrono::nanoseconds & nanoseconds)
{
  const unsigned interrupts = interrupts_;
  detail::sleep(
    static_cast<double>(nanoseconds.count()) / 1e6,
    [this, interrupts] {return !valid_ || interrupts_ != interrupts;});
  return valid_;
}

void Context::interrupt_all_sleep_for()
{
  ++interrupts_;
  detail::wake();
}

contexts::DefaultContext::SharedPtr contexts::get_global_default_context()
{
  // Never destroyed: nodes with static lifetime use it while the program exits.
  static auto * context = new DefaultContext::SharedPtr(std::make_shared<DefaultContext>());
  return *context;
}

GuardCondition::GuardCondition(const Context::SharedPtr & context)
: context_(context)
{
  if (!context) {throw std::invalid_argument("context argument unexpectedly nullptr");}
}

void GuardCondition::trigger()
{
  ++triggers_;
  if (callback_) {callback_(1);}
  detail::wake();
}

void GuardCondition::set_on_trigger_callback(std::function<void(std::size_t)> callback)
{
  callback_ = std::move(callback);
  if (callback_ && triggers_) {callback_(std::exchange(triggers_, 0));}
}

bool GuardCondition::take() {return std::exchange(triggers_, 0) > 0;}

}  // namespace rclcpp
