// Waits for transforms in each of the ways that there are.
#include <Eigen/Core>  // comes with tf2_geometry_msgs

#include <chrono>
#include <memory>
#include <string>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "message_filters/subscriber.h"
#include "rclcpp/rclcpp.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/create_timer_ros.h"
#include "tf2_ros/message_filter.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

using namespace std::chrono_literals;
using geometry_msgs::msg::PointStamped;

class Waiting : public rclcpp::Node
{
public:
  Waiting()
  : Node("waiting"), broadcaster_(this), buffer_(std::make_shared<tf2_ros::Buffer>(get_clock())),
    points_(this, "points", 10)
  {
    buffer_->setCreateTimerInterface(
      std::make_shared<tf2_ros::CreateTimerROS>(
        get_node_base_interface(), get_node_timers_interface()));
    listener_ = std::make_shared<tf2_ros::TransformListener>(*buffer_);
    filter_ = std::make_shared<tf2_ros::MessageFilter<PointStamped>>(
      points_, *buffer_, "world", 100, get_node_logging_interface(), get_node_clock_interface(), 5s);
    filter_->registerCallback(&Waiting::point, this);
    publisher_ = create_publisher<PointStamped>("points", 10);
    timer_ = create_wall_timer(100ms, [this]() {send();});
    once_ = create_wall_timer(10ms, [this]() {
          once_->cancel();
          ask();
        });
  }

private:
  void ask()
  {
    buffer_->waitForTransform(
      "world", "nowhere", tf2_ros::fromRclcpp(now()), 200ms,
      [this](const tf2_ros::TransformStampedFuture & future) {
        try {
          future.get();
        } catch (const tf2::TimeoutException & error) {
          RCLCPP_INFO(get_logger(), "%s", error.what());
          end();
        }
      });
    std::string why;
    if (!buffer_->canTransform("nowhere", "world", tf2::TimePointZero, 50ms, &why)) {
      RCLCPP_INFO(get_logger(), "%s", why.substr(0, why.find(" returned")).c_str());
    }
    // In a callback: the listener has a thread of its own.
    const auto found = buffer_->lookupTransform("world", "map", tf2::TimePointZero, 60s);
    RCLCPP_INFO(get_logger(), "world <- map: %.3f", found.transform.translation.x);
  }

  void send()
  {
    geometry_msgs::msg::TransformStamped moving;
    moving.header.stamp = now();
    moving.header.frame_id = "map";
    moving.child_frame_id = "robot";
    moving.transform.translation.x = 2;
    moving.transform.rotation.w = 1;
    broadcaster_.sendTransform(moving);
    PointStamped point;
    // Of a moment ago, so that it lies between two transforms when the next one comes.
    point.header.stamp = now() - rclcpp::Duration(50ms);
    point.header.frame_id = "robot";
    point.point.x = 1;
    publisher_->publish(point);
  }

  void point(const PointStamped::ConstSharedPtr & message)
  {
    PointStamped moved;
    buffer_->transform(*message, moved, "world");
    if (found_) {return;}
    found_ = true;
    RCLCPP_INFO(
      get_logger(), "point in %s: %.3f %.3f", moved.header.frame_id.c_str(), moved.point.x,
      moved.point.y);
    end();
  }

  /// Done when a point has come, and a transform has not.
  void end()
  {
    if (++ends_ == 2) {rclcpp::shutdown();}
  }

  bool found_ = false;
  int ends_ = 0;
  tf2_ros::TransformBroadcaster broadcaster_;
  std::shared_ptr<tf2_ros::Buffer> buffer_;
  std::shared_ptr<tf2_ros::TransformListener> listener_;
  message_filters::Subscriber<PointStamped> points_;
  std::shared_ptr<tf2_ros::MessageFilter<PointStamped>> filter_;
  rclcpp::Publisher<PointStamped>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::TimerBase::SharedPtr once_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Waiting>());
  rclcpp::shutdown();
  return 0;
}
