#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <string>
#include <utility>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "tf2/buffer_core.hpp"
#include "tf2_ros/buffer_interface.hpp"

namespace tf2_ros
{

/// A future transform, and the number of its request.
class TransformStampedFuture : public std::shared_future<geometry_msgs::msg::TransformStamped>
{
public:
  using Base = std::shared_future<geometry_msgs::msg::TransformStamped>;

  TransformStampedFuture() = default;
  TransformStampedFuture(  // NOLINT: implicit upstream
    std::future<geometry_msgs::msg::TransformStamped> && future) noexcept
  : Base(std::move(future)) {}
  TransformStampedFuture(  // NOLINT: implicit upstream
    Base && future, std::uint64_t handle = 0) noexcept
  : Base(std::move(future)), handle_(handle) {}

  void setHandle(std::uint64_t handle) {handle_ = handle;}
  std::uint64_t getHandle() const {return handle_;}

private:
  std::uint64_t handle_ = 0;
};

using TransformReadyCallback = std::function<void (const TransformStampedFuture &)>;

class AsyncBufferInterface
{
public:
  virtual ~AsyncBufferInterface() = default;

  virtual TransformStampedFuture waitForTransform(
    const std::string & target_frame, const std::string & source_frame,
    const tf2::TimePoint & time, const tf2::Duration & timeout,
    TransformReadyCallback callback) = 0;
  virtual void cancel(const TransformStampedFuture & future) = 0;
};

}  // namespace tf2_ros
