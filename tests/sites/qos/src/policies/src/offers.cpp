// Offers a deadline and says itself that it lives: for two seconds, and then never again.
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("offers");
  const auto logger = node->get_logger();
  rclcpp::PublisherOptions options;
  options.event_callbacks.deadline_callback = [&](rclcpp::QOSDeadlineOfferedInfo & event) {
      RCLCPP_INFO_ONCE(logger, "deadline missed %d", event.total_count_change);
    };
  options.event_callbacks.liveliness_callback = [&](rclcpp::QOSLivelinessLostInfo & event) {
      RCLCPP_INFO(logger, "liveliness lost %d", event.total_count);
    };
  options.event_callbacks.matched_callback = [&](rclcpp::MatchedInfo & event) {
      RCLCPP_INFO(
        logger, "matched %zu of %zu, %+d", event.current_count, event.total_count,
        event.current_count_change);
    };
  const auto qos = rclcpp::QoS(5).deadline(1s).liveliness(rclcpp::LivelinessPolicy::ManualByTopic)
    .liveliness_lease_duration(1s);
  auto publisher = node->create_publisher<std_msgs::msg::String>("vitals", qos, options);
  int count = 0;
  auto timer = node->create_wall_timer(
    100ms, [&]() {
      if (++count > 20) {return;}
      publisher->assert_liveliness();
      if (count % 2 == 0) {publisher->publish(std_msgs::msg::String());}
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
