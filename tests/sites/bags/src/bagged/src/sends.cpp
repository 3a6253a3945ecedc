// Publishes words and poses ten times a second, a latched text once, and serves what it tells about.
#include <chrono>
#include <memory>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"

using namespace std::chrono_literals;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("sends");
  auto words = node->create_publisher<std_msgs::msg::String>("words", 10);
  auto poses = node->create_publisher<geometry_msgs::msg::PoseStamped>(
    "poses", rclcpp::SensorDataQoS());
  auto latched = node->create_publisher<std_msgs::msg::String>(
    "latched", rclcpp::QoS(1).transient_local());
  auto service = node->create_service<std_srvs::srv::SetBool>(
    "switch", [](
      const std::shared_ptr<std_srvs::srv::SetBool::Request> request,
      std::shared_ptr<std_srvs::srv::SetBool::Response> response) {
      response->success = request->data;
      response->message = "switched";
    });
  service->configure_introspection(
    node->get_clock(), rclcpp::QoS(10), RCL_SERVICE_INTROSPECTION_CONTENTS);
  std_msgs::msg::String text;
  text.data = "a map";
  latched->publish(text);
  int count = 0;
  auto timer = node->create_wall_timer(100ms, [&]() {
      std_msgs::msg::String word;
      word.data = "word " + std::to_string(count);
      words->publish(word);
      geometry_msgs::msg::PoseStamped pose;
      pose.header.frame_id = "map";
      pose.header.stamp.sec = count;
      pose.pose.position.x = 0.5 * count;
      poses->publish(pose);
      RCLCPP_INFO(node->get_logger(), "sent %d", count);
      count += 1;
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
