// Publishes a cloud of 100,000 points ten times a second: a square of 20 m with a wave.
#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"

using namespace std::chrono_literals;
using sensor_msgs::msg::PointCloud2;
using sensor_msgs::msg::PointField;

constexpr int kPoints = 100000;
constexpr int kSide = 316;

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("cloud");
  auto publisher = node->create_publisher<PointCloud2>("cloud", 2);
  PointCloud2 cloud;
  cloud.header.frame_id = "map";
  cloud.height = 1;
  cloud.width = kPoints;
  cloud.point_step = 12;
  cloud.row_step = 12 * kPoints;
  for (int n = 0; n < 3; ++n) {
    PointField field;
    field.name = std::string(1, static_cast<char>('x' + n));
    field.offset = 4 * n;
    field.datatype = PointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back(field);
  }
  cloud.data.resize(cloud.row_step);
  int step = 0;
  auto timer = node->create_wall_timer(
    100ms, [&]() {
      ++step;
      for (int n = 0; n < kPoints; ++n) {
        const float x = (n % kSide) * 20.0F / kSide - 10;
        const float y = (n / kSide) * 20.0F / kSide - 10;
        const float point[] = {x, y, std::sin(x + 0.2F * step)};
        std::memcpy(&cloud.data[12 * n], point, sizeof point);
      }
      publisher->publish(cloud);
    });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
