#pragma once

#include <utility>

#include "rclcpp/macros.hpp"

namespace rcpputils
{

/// Runs a callback when it is destroyed, unless it was canceled.
template<typename CallableT>
class scope_exit final
{
public:
  RCLCPP_DISABLE_COPY(scope_exit)

  explicit scope_exit(CallableT callable)
  : callable_(std::move(callable)) {}
  scope_exit(scope_exit && other)
  : callable_(std::move(other.callable_)), canceled_(std::exchange(other.canceled_, true)) {}
  ~scope_exit()
  {
    if (!canceled_) {callable_();}
  }
  void cancel() {canceled_ = true;}

private:
  CallableT callable_;
  bool canceled_ = false;
};

template<typename CallableT>
scope_exit<CallableT> make_scope_exit(CallableT callable)
{
  return scope_exit<CallableT>(std::move(callable));
}

}  // namespace rcpputils

#define RCPPUTILS_SCOPE_EXIT(code) \
  auto RCLCPP_STRING_JOIN(scope_exit_, __LINE__) = rcpputils::make_scope_exit([&]() {code;})
