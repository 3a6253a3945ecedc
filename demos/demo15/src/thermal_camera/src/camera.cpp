// A thermal camera that looks at a part on a hot plate. As a managed node, it sends images only while it is active.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "sensor_msgs/msg/image.hpp"
#include "sensor_msgs/msg/temperature.hpp"

using namespace std::chrono_literals;
using diagnostic_msgs::msg::DiagnosticArray;
using diagnostic_msgs::msg::DiagnosticStatus;
using sensor_msgs::msg::Image;
using sensor_msgs::msg::Temperature;

constexpr int kWidth = 120;
constexpr int kHeight = 90;
constexpr auto kPeriod = 100ms;
constexpr double kRoom = 20;  // °C
constexpr double kPower = 80;  // °C above the room, in the end, with all of the heating
constexpr double kInertia = 4;  // s

using Color = std::array<double, 3>;
// From the temperature of the room to the highest one.
constexpr std::array<Color, 5> kColors{{
  {8, 8, 32}, {90, 16, 130}, {205, 50, 80}, {255, 160, 30}, {255, 250, 210}}};

class Camera : public rclcpp_lifecycle::LifecycleNode
{
public:
  Camera()
  : LifecycleNode("camera")
  {
    declare_parameter("autostart", false);
    declare_parameter("heating", 50, percent());
    declare_parameter("limit", 70.0, degrees());
  }

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    images_ = create_publisher<Image>("image", 10);
    temperatures_ = create_publisher<Temperature>("temperature", 10);
    diagnostics_ = create_publisher<DiagnosticArray>("/diagnostics", 10);
    RCLCPP_INFO(get_logger(), "Configured for %d by %d pixels", kWidth, kHeight);
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
  {
    LifecycleNode::on_activate(state);
    timer_ = create_wall_timer(kPeriod, [this] {look();});
    RCLCPP_INFO(get_logger(), "Looking");
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_deactivate(const rclcpp_lifecycle::State & state) override
  {
    timer_.reset();
    RCLCPP_INFO(get_logger(), "Paused");
    return LifecycleNode::on_deactivate(state);
  }

  CallbackReturn on_cleanup(const rclcpp_lifecycle::State &) override
  {
    images_.reset();
    temperatures_.reset();
    diagnostics_.reset();
    return CallbackReturn::SUCCESS;
  }

private:
  static rcl_interfaces::msg::ParameterDescriptor percent()
  {
    rcl_interfaces::msg::ParameterDescriptor found;
    found.description = "Power of the hot plate in percent";
    found.integer_range.resize(1);
    found.integer_range[0].to_value = 100;
    found.integer_range[0].step = 1;
    return found;
  }

  static rcl_interfaces::msg::ParameterDescriptor degrees()
  {
    rcl_interfaces::msg::ParameterDescriptor found;
    found.description = "Temperature in °C above which the part is too hot";
    found.floating_point_range.resize(1);
    found.floating_point_range[0].from_value = 30;
    found.floating_point_range[0].to_value = 100;
    return found;
  }

  void look()
  {
    const double step = std::chrono::duration<double>(kPeriod).count();
    const double heating = get_parameter("heating").as_int() / 100.0;
    celsius_ += (kRoom + kPower * heating - celsius_) * step / kInertia;
    angle_ += step / 2;
    publish_image();
    publish_temperature();
    // The health once a second.
    if (count_++ % 10 == 0) {publish_health();}
  }

  // The plate turns, and the part on it gets colder towards its edges.
  void publish_image()
  {
    auto image = std::make_unique<Image>();
    image->header.stamp = now();
    image->header.frame_id = "camera";
    image->width = kWidth;
    image->height = kHeight;
    image->encoding = "rgb8";
    image->step = kWidth * 3;
    image->data.reserve(image->step * image->height);
    const double x = kWidth / 2 + 22 * std::cos(angle_);
    const double y = kHeight / 2 + 14 * std::sin(angle_);
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const double far = std::hypot(column - x, row - y) / 20;
        const double heat = (celsius_ - kRoom) / kPower * std::exp(-far * far);
        for (double part : color(heat)) {image->data.push_back(static_cast<std::uint8_t>(part));}
      }
    }
    images_->publish(std::move(image));
  }

  static Color color(double heat)
  {
    const double place = std::clamp(heat, 0.0, 1.0) * (kColors.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), kColors.size() - 2);
    Color found;
    for (std::size_t i = 0; i < found.size(); ++i) {
      found[i] = kColors[below][i] + (place - below) * (kColors[below + 1][i] - kColors[below][i]);
    }
    return found;
  }

  void publish_temperature()
  {
    Temperature message;
    message.header.stamp = now();
    message.header.frame_id = "camera";
    message.temperature = celsius_;
    temperatures_->publish(message);
  }

  void publish_health()
  {
    const double limit = get_parameter("limit").as_double();
    const bool is_hot = celsius_ > limit;
    if (is_hot && !was_hot_) {
      RCLCPP_WARN(get_logger(), "Too hot: %.1f °C, the limit is %.1f °C", celsius_, limit);
    } else if (was_hot_ && !is_hot) {
      RCLCPP_INFO(get_logger(), "Cool again: %.1f °C", celsius_);
    }
    was_hot_ = is_hot;

    DiagnosticStatus part;
    part.name = "camera: Part";
    part.level = is_hot ? DiagnosticStatus::ERROR :
      celsius_ > limit - 10 ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
    part.message = text("%.1f °C", celsius_);
    part.values.resize(1);
    part.values[0].key = "limit";
    part.values[0].value = text("%.1f °C", limit);
    DiagnosticStatus images;
    images.name = "camera: Images";
    images.level = DiagnosticStatus::OK;
    images.message = std::to_string(count_) + " sent";
    DiagnosticArray message;
    message.header.stamp = now();
    message.status = {part, images};
    diagnostics_->publish(message);
  }

  static std::string text(const char * format, double value)
  {
    std::array<char, 32> found;
    std::snprintf(found.data(), found.size(), format, value);
    return found.data();
  }

  double celsius_ = kRoom;
  double angle_ = 0;
  int count_ = 0;
  bool was_hot_ = false;
  rclcpp_lifecycle::LifecyclePublisher<Image>::SharedPtr images_;
  rclcpp_lifecycle::LifecyclePublisher<Temperature>::SharedPtr temperatures_;
  rclcpp_lifecycle::LifecyclePublisher<DiagnosticArray>::SharedPtr diagnostics_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const auto camera = std::make_shared<Camera>();
  if (camera->get_parameter("autostart").as_bool()) {
    camera->configure();
    camera->activate();
  }
  rclcpp::spin(camera->get_node_base_interface());
  rclcpp::shutdown();
  return 0;
}
