// Publishes the name of a colour on /color every second.
#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;

class ColorPublisher : public rclcpp::Node
{
public:
  ColorPublisher()
  : Node("color_publisher")
  {
    publisher_ = create_publisher<std_msgs::msg::String>("color", 10);
    timer_ = create_wall_timer(1s, std::bind(&ColorPublisher::on_timer, this));
  }

private:
  void on_timer()
  {
    static const std::array<std::string, 5> colors{"red", "yellow", "green", "blue", "purple"};
    std_msgs::msg::String message;
    message.data = colors[count_++ % colors.size()];
    RCLCPP_INFO(get_logger(), "Publishing: '%s'", message.data.c_str());
    publisher_->publish(message);
  }

  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::size_t count_ = 0;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<ColorPublisher>());
  rclcpp::shutdown();
  return 0;
}
