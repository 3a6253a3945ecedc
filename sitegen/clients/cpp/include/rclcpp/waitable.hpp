#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "rcl/wait.h"
#include "rclcpp/detail/executable.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

class TimerBase;

/// Something of one's own that executors and wait sets wait for. What it waits for are guard conditions,
/// or nothing: then it says by itself whether it is ready, and is asked whenever anything happens.
/// Each call has the form of Jazzy and that of Humble; a class has either.
class Waitable : public detail::Executable
{
public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(Waitable)

  virtual std::size_t get_number_of_ready_subscriptions() {return 0;}
  virtual std::size_t get_number_of_ready_timers() {return 0;}
  virtual std::size_t get_number_of_ready_clients() {return 0;}
  virtual std::size_t get_number_of_ready_events() {return 0;}
  virtual std::size_t get_number_of_ready_services() {return 0;}
  virtual std::size_t get_number_of_ready_guard_conditions() {return 0;}

  virtual void add_to_wait_set(rcl_wait_set_t & wait_set) {add_to_wait_set(&wait_set);}
  virtual void add_to_wait_set(rcl_wait_set_t *) {}
  virtual bool is_ready(const rcl_wait_set_t & wait_set)
  {
    rcl_wait_set_t copy = wait_set;
    return is_ready(&copy);
  }
  virtual bool is_ready(rcl_wait_set_t *) {return false;}
  virtual std::shared_ptr<void> take_data() {return nullptr;}
  virtual std::shared_ptr<void> take_data_by_entity_id(std::size_t) {return take_data();}
  virtual void execute(const std::shared_ptr<void> & data)
  {
    std::shared_ptr<void> copy = data;
    execute(copy);
  }
  virtual void execute(std::shared_ptr<void> &) {}
  virtual void set_on_ready_callback(std::function<void (std::size_t, int)>) {}
  virtual void clear_on_ready_callback() {}
  virtual std::vector<std::shared_ptr<TimerBase>> get_timers() const {return {};}
  bool exchange_in_use_by_wait_set_state(bool in_use);

  /// Whether it is ready now. The guard conditions that it waits for are triggered no more after that.
  virtual bool look();
  bool execute_one() override;

private:
  bool in_use_by_wait_set_ = false;
};

}  // namespace rclcpp
