// Moved to rcpputils; kept for programs that include it from here.
#pragma once

#include "rcpputils/scope_exit.hpp"

namespace rclcpp
{

template<typename CallableT>
using ScopeExit = rcpputils::scope_exit<CallableT>;

template<typename CallableT>
ScopeExit<CallableT> make_scope_exit(CallableT callable)
{
  return rcpputils::make_scope_exit(std::move(callable));
}

}  // namespace rclcpp

#define RCLCPP_SCOPE_EXIT(code) RCPPUTILS_SCOPE_EXIT(code)
