// What a robot measures: its health, its battery and a picture; and what it sees through the visitor's camera.
#include <chrono>
#include <string>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/battery_state.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
#include "sensor_msgs/msg/image.hpp"

using namespace std::chrono_literals;
using diagnostic_msgs::msg::DiagnosticArray;
using diagnostic_msgs::msg::DiagnosticStatus;
using diagnostic_msgs::msg::KeyValue;
using sensor_msgs::msg::BatteryState;
using sensor_msgs::msg::CameraInfo;
using sensor_msgs::msg::Image;

class Gauges : public rclcpp::Node
{
public:
  Gauges()
  : Node("gauges", rclcpp::NodeOptions().enable_logger_service(true))
  {
    image_subscription_ = create_subscription<Image>("image_raw", 10, [this](const Image & image) {see(image);});
    info_subscription_ = create_subscription<CameraInfo>("camera_info", 10, [this](const CameraInfo & info) {
      RCLCPP_INFO_ONCE(get_logger(), "camera info %ux%u", info.width, info.height);
    });
    timer_ = create_wall_timer(200ms, [this] {measure();});
  }

private:
  void see(const Image & image)
  {
    RCLCPP_INFO_ONCE(
      get_logger(), "camera %ux%u %s in %s, %zu bytes", image.width, image.height, image.encoding.c_str(),
      image.header.frame_id.c_str(), image.data.size());
  }

  void measure()
  {
    ++count_;
    RCLCPP_DEBUG(get_logger(), "measurement %d", count_);
    BatteryState battery;
    battery.percentage = count_ < 5 ? 0.8F : 0.15F;
    battery_->publish(battery);
    picture_->publish(picture());
    DiagnosticArray array;
    array.header.stamp = now();
    array.status.push_back(status("arm: left motor", DiagnosticStatus::OK, "cool"));
    array.status.push_back(status("arm: right motor", DiagnosticStatus::WARN, "warm"));
    array.status.push_back(status("base: laser", DiagnosticStatus::ERROR, "<b>no echo</b>"));
    // It falls silent.
    if (count_ == 1) {array.status.push_back(status("base: gripper", DiagnosticStatus::OK, "open"));}
    diagnostics_->publish(array);
  }

  // Red on the left, blue on the right.
  Image picture() const
  {
    Image image;
    image.width = 4;
    image.height = 2;
    image.encoding = "rgb8";
    image.step = 12;
    for (int pixel = 0; pixel < 8; ++pixel) {
      const bool left = pixel % 4 < 2;
      for (const int value : {left ? 250 : 10, 20, left ? 10 : 250}) {image.data.push_back(value);}
    }
    return image;
  }

  DiagnosticStatus status(const std::string & name, unsigned char level, const std::string & message) const
  {
    DiagnosticStatus status;
    status.name = name;
    status.level = level;
    status.message = message;
    status.hardware_id = "bus-7";
    for (const auto & [key, value] : {std::pair{"count", std::to_string(count_)}, {"unit", "K & <i>"}}) {
      KeyValue pair;
      pair.key = key;
      pair.value = value;
      status.values.push_back(pair);
    }
    return status;
  }

  int count_ = 0;
  rclcpp::Publisher<BatteryState>::SharedPtr battery_ = create_publisher<BatteryState>("battery", 10);
  rclcpp::Publisher<Image>::SharedPtr picture_ = create_publisher<Image>("picture", 10);
  rclcpp::Publisher<DiagnosticArray>::SharedPtr diagnostics_ = create_publisher<DiagnosticArray>("diagnostics", 10);
  rclcpp::Subscription<Image>::SharedPtr image_subscription_;
  rclcpp::Subscription<CameraInfo>::SharedPtr info_subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Gauges>());
  rclcpp::shutdown();
}
