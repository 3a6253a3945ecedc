// Publishes texts and stamped points, has parameters and a service, and repeats what it hears.

#include <memory>
#include <string>

#include "geometry_msgs/msg/point_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
#include "std_srvs/srv/set_bool.hpp"

using geometry_msgs::msg::PointStamped;
using std_msgs::msg::String;
using std_srvs::srv::SetBool;

class Talker : public rclcpp::Node
{
public:
  Talker()
  : Node("talker")
  {
    rcl_interfaces::msg::ParameterDescriptor volume;
    volume.description = "How loud it is";
    volume.integer_range.resize(1);
    volume.integer_range[0].from_value = 0;
    volume.integer_range[0].to_value = 11;
    declare_parameter("volume", 5, volume);
    declare_parameter("greeting", "hello");
    declare_parameter("speed", 1.0);
    texts_ = create_publisher<String>("chatter", 10);
    points_ = create_publisher<PointStamped>("points", rclcpp::QoS(1).transient_local());
    heard_ = create_subscription<String>("said", 10, [this](const String & message) {
      RCLCPP_INFO(get_logger(), "heard '%s'", message.data.c_str());
    });
    mute_ = create_service<SetBool>("mute",
      [](SetBool::Request::SharedPtr request, SetBool::Response::SharedPtr response) {
        response->success = request->data;
        response->message = request->data ? "muted" : "it's on";
      });
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this] {speak();});
    RCLCPP_INFO(get_logger(), "%s", get_parameter("greeting").as_string().c_str());
  }

private:
  void speak()
  {
    String text;
    text.data = get_parameter("greeting").as_string() + " " + std::to_string(++count_);
    texts_->publish(text);
    PointStamped point;
    point.header.stamp = now();
    point.header.frame_id = "map";
    point.point.x = 1.5;
    points_->publish(point);
  }

  int count_ = 0;
  rclcpp::Publisher<String>::SharedPtr texts_;
  rclcpp::Publisher<PointStamped>::SharedPtr points_;
  rclcpp::Subscription<String>::SharedPtr heard_;
  rclcpp::Service<SetBool>::SharedPtr mute_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
  rclcpp::shutdown();
  return 0;
}
