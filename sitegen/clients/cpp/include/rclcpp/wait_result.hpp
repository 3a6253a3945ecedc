#pragma once

#include <memory>
#include <stdexcept>
#include <utility>

#include "rclcpp/wait_result_kind.hpp"

namespace rclcpp
{

/// The result of a wait, with the wait set to get what is ready.
template<class WaitSetT>
class WaitResult final
{
public:
  WaitResult(WaitResultKind kind, WaitSetT & wait_set)
  : kind_(kind), wait_set_(&wait_set) {}

  WaitResultKind kind() const {return kind_;}
  const WaitSetT & get_wait_set() const {return *require();}
  WaitSetT & get_wait_set() {return *require();}

  /// The next ready entity of each kind, or null; each is returned once.
  auto next_ready_timer() {return require()->next_ready_timer();}
  auto next_ready_subscription() {return require()->next_ready_subscription();}
  auto next_ready_service() {return require()->next_ready_service();}
  auto next_ready_client() {return require()->next_ready_client();}
  auto next_ready_waitable() {return require()->next_ready_waitable();}

private:
  WaitSetT * require() const
  {
    if (kind_ != WaitResultKind::Ready) {
      throw std::runtime_error("cannot access wait set when the result was not ready");
    }
    return wait_set_;
  }

  WaitResultKind kind_;
  WaitSetT * wait_set_;
};

}  // namespace rclcpp
