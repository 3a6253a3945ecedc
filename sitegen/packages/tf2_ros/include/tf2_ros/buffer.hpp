#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "rclcpp/rclcpp.hpp"
#include "tf2/buffer_core.hpp"
#include "tf2_msgs/srv/frame_graph.hpp"
#include "tf2_ros/async_buffer_interface.hpp"
#include "tf2_ros/buffer_interface.hpp"
#include "tf2_ros/create_timer_interface.hpp"

namespace tf2_ros
{

extern const char * const threading_error;

/// A buffer that can wait for transforms; a TransformListener fills it.
class Buffer : public BufferInterface, public AsyncBufferInterface, public tf2::BufferCore
{
public:
  using SharedPtr = std::shared_ptr<Buffer>;
  using BufferCore::canTransform;
  using BufferCore::lookupTransform;

  explicit Buffer(
    rclcpp::Clock::SharedPtr clock,
    tf2::Duration cache_time = tf2::BUFFER_CORE_DEFAULT_CACHE_TIME);
  /// `node` is a pointer to a node, which provides the service tf2_frames.
  template<class NodeT>
  Buffer(
    rclcpp::Clock::SharedPtr clock, tf2::Duration cache_time, NodeT && node,
    const rclcpp::QoS & qos = rclcpp::ServicesQoS())
  : Buffer(std::move(clock), cache_time)
  {
    logger_ = node->get_logger();
    frames_server_ = node->template create_service<tf2_msgs::srv::FrameGraph>(
      "tf2_frames",
      [this](
        const std::shared_ptr<tf2_msgs::srv::FrameGraph::Request>,
        std::shared_ptr<tf2_msgs::srv::FrameGraph::Response> response) {
        response->frame_yaml = allFramesAsYAML();
      }, qos);
  }

  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame,
    const tf2::TimePoint & time, const tf2::Duration timeout) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const std::string & source_frame, const rclcpp::Time & time,
    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0)) const
  {
    return lookupTransform(target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout));
  }
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & source_frame, const tf2::TimePoint & source_time,
    const std::string & fixed_frame, const tf2::Duration timeout) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target_frame, const rclcpp::Time & target_time,
    const std::string & source_frame, const rclcpp::Time & source_time,
    const std::string & fixed_frame,
    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0)) const
  {
    return lookupTransform(
      target_frame, fromRclcpp(target_time), source_frame, fromRclcpp(source_time), fixed_frame,
      fromRclcpp(timeout));
  }

  bool canTransform(
    const std::string & target_frame, const std::string & source_frame,
    const tf2::TimePoint & time, const tf2::Duration timeout,
    std::string * error = nullptr) const override;
  bool canTransform(
    const std::string & target_frame, const std::string & source_frame, const rclcpp::Time & time,
    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0),
    std::string * error = nullptr) const
  {
    return canTransform(
      target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout), error);
  }
  bool canTransform(
    const std::string & target_frame, const tf2::TimePoint & target_time,
    const std::string & source_frame, const tf2::TimePoint & source_time,
    const std::string & fixed_frame, const tf2::Duration timeout,
    std::string * error = nullptr) const override;
  bool canTransform(
    const std::string & target_frame, const rclcpp::Time & target_time,
    const std::string & source_frame, const rclcpp::Time & source_time,
    const std::string & fixed_frame,
    const rclcpp::Duration timeout = rclcpp::Duration::from_nanoseconds(0),
    std::string * error = nullptr) const
  {
    return canTransform(
      target_frame, fromRclcpp(target_time), source_frame, fromRclcpp(source_time), fixed_frame,
      fromRclcpp(timeout), error);
  }

  /// Throws CreateTimerInterfaceException if no timer interface is set.
  TransformStampedFuture waitForTransform(
    const std::string & target_frame, const std::string & source_frame,
    const tf2::TimePoint & time, const tf2::Duration & timeout,
    TransformReadyCallback callback) override;
  TransformStampedFuture waitForTransform(
    const std::string & target_frame, const std::string & source_frame, const rclcpp::Time & time,
    const rclcpp::Duration & timeout, TransformReadyCallback callback)
  {
    return waitForTransform(
      target_frame, source_frame, fromRclcpp(time), fromRclcpp(timeout), std::move(callback));
  }
  void cancel(const TransformStampedFuture & future) override;
  void setCreateTimerInterface(CreateTimerInterface::SharedPtr timer_interface)
  {
    timer_interface_ = std::move(timer_interface);
  }
  rclcpp::Clock::SharedPtr getClock() const {return clock_;}

private:
  /// Call `can` repeatedly until it returns true, or until `timeout`. Its argument is null, in the
  /// last call `error`.
  bool wait(
    const std::function<bool(std::string *)> & can, tf2::Duration timeout,
    std::string * error) const;
  void remove_timer(tf2::TransformableRequestHandle request);

  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_ = rclcpp::get_logger("tf2_buffer");
  rclcpp::Service<tf2_msgs::srv::FrameGraph>::SharedPtr frames_server_;
  rclcpp::JumpHandler::SharedPtr jump_handler_;
  CreateTimerInterface::SharedPtr timer_interface_;
  std::mutex timers_mutex_;
  std::unordered_map<tf2::TransformableRequestHandle, TimerHandle> timers_;
};

}  // namespace tf2_ros
