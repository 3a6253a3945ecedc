#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>

#include "rclcpp/clock.hpp"
#include "tf2/time.hpp"

namespace tf2_ros
{

using TimerHandle = std::uint64_t;
using TimerCallbackType = std::function<void (const TimerHandle &)>;

class CreateTimerInterfaceException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class InvalidTimerHandleException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Creates the timers with which a buffer limits waits for transforms.
class CreateTimerInterface
{
public:
  using SharedPtr = std::shared_ptr<CreateTimerInterface>;
  using ConstSharedPtr = std::shared_ptr<const CreateTimerInterface>;
  using UniquePtr = std::unique_ptr<CreateTimerInterface>;

  virtual ~CreateTimerInterface() = default;
  virtual TimerHandle createTimer(
    rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, TimerCallbackType callback) = 0;
  virtual void cancel(const TimerHandle & timer_handle) = 0;
  virtual void reset(const TimerHandle & timer_handle) = 0;
  virtual void remove(const TimerHandle & timer_handle) = 0;
};

}  // namespace tf2_ros
