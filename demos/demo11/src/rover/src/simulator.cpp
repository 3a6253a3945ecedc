// A rover that drives through a room: it follows /cmd_vel, and publishes its odometry, what its laser scanner sees, and
// the map of the room, and its walls as markers.

#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "visualization_msgs/msg/marker.hpp"

using namespace std::chrono_literals;

namespace
{

// The room from above, a quarter of a metre for each character; x goes to the right and y up.
constexpr double CELL = 0.25;
const std::array<std::string, 20> ROOM = {
  "################################",
  "#..............#...............#",
  "#..............#...............#",
  "#..............#....####.......#",
  "#...................####.......#",
  "#...................####.......#",
  "#......##......................#",
  "#......##......#...............#",
  "#..............#...............#",
  "#..............#...............#",
  "######....######...............#",
  "#..............#...............#",
  "#..............######....#######",
  "#..............................#",
  "#..............................#",
  "#....................##........#",
  "#...##...............##........#",
  "#...##.......#.................#",
  "#............#.................#",
  "################################",
};
constexpr double HEIGHT = 0.4;  // of the walls, in metres
constexpr double RADIUS = 0.3;  // of the rover, in metres
constexpr double STEP = 0.05;  // seconds
constexpr int BEAMS = 180;
constexpr double FAR = 6.0;  // of the scanner, in metres
constexpr double LASER = 0.12;  // from the middle of the rover to the scanner, in metres

bool is_wall(double x, double y)
{
  const auto column = static_cast<int>(std::floor(x / CELL));
  const auto row = static_cast<int>(ROOM.size()) - 1 - static_cast<int>(std::floor(y / CELL));
  if (row < 0 || row >= static_cast<int>(ROOM.size()) || column < 0) {
    return true;
  }
  return column >= static_cast<int>(ROOM[row].size()) || ROOM[row][column] == '#';
}

}  // namespace

class Simulator : public rclcpp::Node
{
public:
  Simulator()
  : Node("simulator"), broadcaster_(*this), static_broadcaster_(*this)
  {
    odometry_ = create_publisher<nav_msgs::msg::Odometry>("odom", 10);
    scan_ = create_publisher<sensor_msgs::msg::LaserScan>("scan", rclcpp::SensorDataQoS());
    map_ = create_publisher<nav_msgs::msg::OccupancyGrid>("map", rclcpp::QoS(1).transient_local());
    walls_ = create_publisher<visualization_msgs::msg::Marker>("walls", rclcpp::QoS(1).transient_local());
    commands_ = create_subscription<geometry_msgs::msg::Twist>(
      "cmd_vel", 10, [this](const geometry_msgs::msg::Twist & command) {
        command_ = command;
        heard_ = now();
      });
    publish_map();
    publish_walls();
    geometry_msgs::msg::TransformStamped start;
    start.header.stamp = now();
    start.header.frame_id = "map";
    start.child_frame_id = "odom";
    start.transform.translation.x = x_;
    start.transform.translation.y = y_;
    start.transform.rotation.w = 1;
    static_broadcaster_.sendTransform(start);
    x0_ = x_;
    y0_ = y_;
    timer_ = create_wall_timer(50ms, [this] {step();});
    RCLCPP_INFO(get_logger(), "Drive me: I listen to /cmd_vel");
  }

private:
  void step()
  {
    // Without a command for half a second, it stops.
    if ((now() - heard_).seconds() > 0.5) {
      command_ = geometry_msgs::msg::Twist();
    }
    yaw_ += command_.angular.z * STEP;
    const double x = x_ + command_.linear.x * STEP * std::cos(yaw_);
    const double y = y_ + command_.linear.x * STEP * std::sin(yaw_);
    const bool blocked = hits(x, y);
    if (blocked && !blocked_) {
      RCLCPP_WARN(get_logger(), "Bump! A wall at %.2f, %.2f", x, y);
    }
    blocked_ = blocked;
    if (!blocked) {
      x_ = x;
      y_ = y;
    }
    publish_odometry();
    if (++steps_ % 2 == 0) {
      publish_scan();
    }
  }

  static bool hits(double x, double y)
  {
    for (int index = 0; index < 12; ++index) {
      const double angle = index * M_PI / 6;
      if (is_wall(x + RADIUS * std::cos(angle), y + RADIUS * std::sin(angle))) {
        return true;
      }
    }
    return false;
  }

  void publish_odometry()
  {
    nav_msgs::msg::Odometry odometry;
    odometry.header.stamp = now();
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.pose.pose.position.x = x_ - x0_;
    odometry.pose.pose.position.y = y_ - y0_;
    odometry.pose.pose.orientation.z = std::sin(yaw_ / 2);
    odometry.pose.pose.orientation.w = std::cos(yaw_ / 2);
    odometry.twist.twist = command_;
    odometry_->publish(odometry);
    geometry_msgs::msg::TransformStamped transform;
    transform.header = odometry.header;
    transform.child_frame_id = "base_link";
    transform.transform.translation.x = odometry.pose.pose.position.x;
    transform.transform.translation.y = odometry.pose.pose.position.y;
    transform.transform.rotation = odometry.pose.pose.orientation;
    broadcaster_.sendTransform(transform);
  }

  void publish_scan()
  {
    sensor_msgs::msg::LaserScan scan;
    scan.header.stamp = now();
    scan.header.frame_id = "laser";
    scan.angle_min = -M_PI;
    scan.angle_increment = 2 * M_PI / BEAMS;
    scan.angle_max = scan.angle_min + (BEAMS - 1) * scan.angle_increment;
    scan.range_min = 0.05;
    scan.range_max = FAR;
    const double x = x_ + LASER * std::cos(yaw_);
    const double y = y_ + LASER * std::sin(yaw_);
    for (int beam = 0; beam < BEAMS; ++beam) {
      scan.ranges.push_back(range(x, y, yaw_ + scan.angle_min + beam * scan.angle_increment));
    }
    scan_->publish(scan);
  }

  static float range(double x, double y, double angle)
  {
    for (double far = 0; far < FAR; far += 0.02) {
      if (is_wall(x + far * std::cos(angle), y + far * std::sin(angle))) {
        return far;
      }
    }
    return std::numeric_limits<float>::infinity();
  }

  void publish_map()
  {
    nav_msgs::msg::OccupancyGrid map;
    map.header.stamp = now();
    map.header.frame_id = "map";
    map.info.resolution = CELL;
    map.info.width = ROOM[0].size();
    map.info.height = ROOM.size();
    map.info.origin.orientation.w = 1;
    for (auto row = ROOM.rbegin(); row != ROOM.rend(); ++row) {
      for (const char cell : *row) {
        map.data.push_back(cell == '#' ? 100 : 0);
      }
    }
    map_->publish(map);
  }

  void publish_walls()
  {
    visualization_msgs::msg::Marker walls;
    walls.header.stamp = now();
    walls.header.frame_id = "map";
    walls.ns = "walls";
    walls.type = visualization_msgs::msg::Marker::CUBE_LIST;
    walls.pose.orientation.w = 1;
    walls.scale.x = CELL;
    walls.scale.y = CELL;
    walls.scale.z = HEIGHT;
    walls.color.r = 0.55;
    walls.color.g = 0.61;
    walls.color.b = 0.73;
    walls.color.a = 1;
    for (size_t row = 0; row < ROOM.size(); ++row) {
      for (size_t column = 0; column < ROOM[row].size(); ++column) {
        if (ROOM[row][column] == '#') {
          geometry_msgs::msg::Point middle;
          middle.x = (column + 0.5) * CELL;
          middle.y = (ROOM.size() - row - 0.5) * CELL;
          middle.z = HEIGHT / 2;
          walls.points.push_back(middle);
        }
      }
    }
    walls_->publish(walls);
  }

  double x_ = 2.0, y_ = 1.0, yaw_ = 0.0;
  double x0_, y0_;
  bool blocked_ = false;
  int steps_ = 0;
  geometry_msgs::msg::Twist command_;
  rclcpp::Time heard_ = now();
  tf2_ros::TransformBroadcaster broadcaster_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  rclcpp::Publisher<nav_msgs::msg::Odometry>::SharedPtr odometry_;
  rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr scan_;
  rclcpp::Publisher<nav_msgs::msg::OccupancyGrid>::SharedPtr map_;
  rclcpp::Publisher<visualization_msgs::msg::Marker>::SharedPtr walls_;
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr commands_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Simulator>());
  rclcpp::shutdown();
  return 0;
}
