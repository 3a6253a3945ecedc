#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <typeindex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "rclcpp/detail/arguments.hpp"
#include "rclcpp/init_options.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

class ContextAlreadyInitialized : public std::runtime_error
{
public:
  ContextAlreadyInitialized()
  : std::runtime_error("context is already initialized") {}
};

/// The handle of a shutdown callback, by which to remove it.
struct ShutdownCallbackHandle
{
  using ShutdownCallbackType = std::function<void ()>;
  std::weak_ptr<ShutdownCallbackType> callback;
};
using OnShutdownCallbackHandle = ShutdownCallbackHandle;
using PreShutdownCallbackHandle = ShutdownCallbackHandle;

/// ROS from initialization to shutdown, with its arguments.
class Context : public std::enable_shared_from_this<Context>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Context)
  RCLCPP_DISABLE_COPY(Context)

  using OnShutdownCallback = std::function<void ()>;
  using PreShutdownCallback = std::function<void ()>;

  Context() = default;
  virtual ~Context() = default;

  /// Throws ContextAlreadyInitialized, or UnknownROSArgsError for unknown arguments.
  virtual void init(
    int argc, char const * const * argv, const InitOptions & init_options = InitOptions());
  bool is_valid() const {return valid_;}
  const InitOptions & get_init_options() const {return options_;}
  std::size_t get_domain_id() const {return options_.get_domain_id();}
  std::string shutdown_reason() const {return reason_;}
  virtual bool shutdown(const std::string & reason);
  virtual OnShutdownCallback on_shutdown(OnShutdownCallback callback);
  virtual OnShutdownCallbackHandle add_on_shutdown_callback(OnShutdownCallback callback);
  virtual bool remove_on_shutdown_callback(const OnShutdownCallbackHandle & handle);
  virtual PreShutdownCallbackHandle add_pre_shutdown_callback(PreShutdownCallback callback);
  virtual bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle & handle);
  std::vector<OnShutdownCallback> get_on_shutdown_callbacks() const;
  std::vector<PreShutdownCallback> get_pre_shutdown_callbacks() const;
  /// The one object of a class that belongs to this context, made with `args` by the first call.
  template<class SubContext, class ... Args>
  std::shared_ptr<SubContext> get_sub_context(Args && ... args)
  {
    auto & found = sub_contexts_[std::type_index(typeid(SubContext))];
    if (!found) {found = std::make_shared<SubContext>(std::forward<Args>(args) ...);}
    return std::static_pointer_cast<SubContext>(found);
  }
  /// Sleep; false on shutdown.
  bool sleep_for(const std::chrono::nanoseconds & nanoseconds);
  void interrupt_all_sleep_for();

  const detail::Arguments & arguments() const {return arguments_;}

private:
  using Callbacks = std::vector<std::shared_ptr<OnShutdownCallback>>;

  bool valid_ = false;
  unsigned interrupts_ = 0;
  std::string reason_;
  InitOptions options_;
  detail::Arguments arguments_;
  Callbacks on_shutdown_;
  Callbacks pre_shutdown_;
  std::unordered_map<std::type_index, std::shared_ptr<void>> sub_contexts_;
};

}  // namespace rclcpp
