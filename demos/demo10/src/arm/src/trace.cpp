// Draws where the tool of the arm was, as a line of markers.

#include <chrono>
#include <cmath>
#include <deque>
#include <memory>

#include "geometry_msgs/msg/point.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_listener.h"
#include "visualization_msgs/msg/marker.hpp"

using namespace std::chrono_literals;

class Trace : public rclcpp::Node
{
public:
  Trace()
  : Node("trace"), buffer_(get_clock()), listener_(buffer_)
  {
    rcl_interfaces::msg::ParameterDescriptor length;
    length.description = "points of the line";
    length.integer_range.resize(1);
    length.integer_range[0].from_value = 2;
    length.integer_range[0].to_value = 1000;
    declare_parameter("length", 300, length);
    rcl_interfaces::msg::ParameterDescriptor width;
    width.description = "width of the line, in metres";
    width.floating_point_range.resize(1);
    width.floating_point_range[0].from_value = 0.002;
    width.floating_point_range[0].to_value = 0.05;
    declare_parameter("width", 0.012, width);
    publisher_ = create_publisher<visualization_msgs::msg::Marker>("trace", 10);
    timer_ = create_wall_timer(50ms, [this] {draw();});
  }

private:
  void draw()
  {
    geometry_msgs::msg::TransformStamped tool;
    try {
      tool = buffer_.lookupTransform("world", "tool", tf2::TimePointZero);
    } catch (const tf2::TransformException &) {
      return;  // until the state of the joints is known
    }
    geometry_msgs::msg::Point point;
    point.x = tool.transform.translation.x;
    point.y = tool.transform.translation.y;
    point.z = tool.transform.translation.z;
    if (points_.empty() || distance(points_.back(), point) > 0.005) {
      points_.push_back(point);
      RCLCPP_INFO(get_logger(), "tool at %.2f %.2f %.2f", point.x, point.y, point.z);
    }
    while (points_.size() > static_cast<size_t>(get_parameter("length").as_int())) {
      points_.pop_front();
    }
    visualization_msgs::msg::Marker line;
    line.header.frame_id = "world";
    line.ns = "trace";
    line.type = visualization_msgs::msg::Marker::LINE_STRIP;
    line.scale.x = get_parameter("width").as_double();
    line.pose.orientation.w = 1;
    line.color.r = 1.0;
    line.color.g = 0.6;
    line.color.b = 0.15;
    line.color.a = 1.0;
    line.points.assign(points_.begin(), points_.end());
    publisher_->publish(line);
  }

  static double distance(const geometry_msgs::msg::Point & a, const geometry_msgs::msg::Point & b)
  {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  }

  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  std::deque<geometry_msgs::msg::Point> points_;
  rclcpp::Publisher<visualization_msgs::msg::Marker>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Trace>());
  rclcpp::shutdown();
  return 0;
}
