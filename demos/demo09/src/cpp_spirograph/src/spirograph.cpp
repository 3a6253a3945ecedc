// Makes the turtle draw one figure after another, and lets go of it when somebody else drives.
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/empty.hpp"
#include "turtlesim/msg/pose.hpp"
#include "turtlesim/srv/set_pen.hpp"
#include "turtlesim/srv/teleport_absolute.hpp"

using namespace std::chrono_literals;
using geometry_msgs::msg::Twist;
using std_srvs::srv::Empty;
using turtlesim::msg::Pose;
using turtlesim::srv::SetPen;
using turtlesim::srv::TeleportAbsolute;

struct Figure
{
  int waves;
  int turns;
  double speed;
  double height;
  std::uint8_t red, green, blue;
};

constexpr double kTurn = 1.5;  // rad/s

// #region figures
constexpr std::array<Figure, 5> kFigures{{
  // waves, turns, speed, height, color
  {5, 2, 2.0, 13.5, 255, 255, 255},
  {7, 3, 0.0, 13.0, 255, 200, 87},
  {4, 3, 3.0, 3.0, 122, 240, 190},
  {8, 5, 1.8, 6.3, 255, 160, 190},
  {12, 5, 1.2, 13.2, 150, 225, 255},
}};

// It turns steadily, and its speed is a wave.
Twist step(const Figure & f, double angle)
{
  const double wave =
    std::cos(angle * f.waves / f.turns);
  Twist twist;
  twist.linear.x = f.speed + f.height * wave;
  twist.angular.z = kTurn;
  return twist;
}
// #endregion

constexpr double kMiddle = 5.54;  // of the window, in both directions
constexpr auto kPause = 2s;  // between two figures
constexpr auto kYours = 5s;  // how long you have the turtle after your last command

class Spirograph : public rclcpp::Node
{
public:
  Spirograph()
  : Node("spirograph")
  {
    publisher_ = create_publisher<Twist>("turtle1/cmd_vel", 10);
    pen_ = create_client<SetPen>("turtle1/set_pen");
    teleport_ = create_client<TeleportAbsolute>("turtle1/teleport_absolute");
    clear_ = create_client<Empty>("clear");
    poses_ = create_subscription<Pose>(
      "turtle1/pose", 10, [this](const Pose & pose) {on_pose(pose);});
    rclcpp::SubscriptionOptions options;
    options.ignore_local_publications = true;
    others_ = create_subscription<Twist>(
      "turtle1/cmd_vel", 10, [this](const Twist &) {let_go();}, options);
    begin_in(100ms);
  }

private:
  void on_pose(const Pose & pose)
  {
    if (!is_drawing_) {return;}
    turned_ += std::remainder(pose.theta - heading_, 2 * M_PI);
    heading_ = pose.theta;
    if (turned_ < 2 * M_PI * figure().turns) {
      publisher_->publish(step(figure(), turned_));
      return;
    }
    publisher_->publish(Twist());
    is_drawing_ = false;
    number_ = (number_ + 1) % kFigures.size();
    begin_in(kPause);
  }

  const Figure & figure() const {return kFigures[number_];}

  void begin_in(std::chrono::milliseconds time)
  {
    timer_ = create_wall_timer(time, [this] {begin();});
  }

  void begin()
  {
    if (!pen_->service_is_ready() || !teleport_->service_is_ready()) {return;}
    is_yours_ = false;
    // Without an answer, because turtlesim has stopped, for example, it begins again.
    begin_in(kYours);
    set_pen(1, [this] {teleport([this] {set_pen(0, [this] {clear([this] {draw();});});});});
  }

  void draw()
  {
    if (is_yours_) {return;}
    timer_->cancel();
    RCLCPP_INFO(get_logger(), "%d waves in %d turns", figure().waves, figure().turns);
    turned_ = heading_ = 0;
    is_drawing_ = true;
  }

  // Somebody else drives the turtle.
  void let_go()
  {
    if (is_drawing_) {RCLCPP_INFO(get_logger(), "The turtle is yours");}
    is_drawing_ = false;
    is_yours_ = true;
    begin_in(kYours);
  }

  template<typename ThenT>
  void set_pen(std::uint8_t off, ThenT then)
  {
    auto pen = std::make_shared<SetPen::Request>();
    pen->r = figure().red;
    pen->g = figure().green;
    pen->b = figure().blue;
    pen->width = 3;
    pen->off = off;
    pen_->async_send_request(pen, [then](rclcpp::Client<SetPen>::SharedFuture) {then();});
  }

  // To where the figure begins, so that it is in the middle of the window.
  template<typename ThenT>
  void teleport(ThenT then)
  {
    const double ratio = static_cast<double>(figure().waves) / figure().turns;
    const double waves = figure().height / 2 * (1 / (1 + ratio) + 1 / (1 - ratio));
    auto place = std::make_shared<TeleportAbsolute::Request>();
    place->x = kMiddle;
    place->y = kMiddle - (figure().speed + waves) / kTurn;
    place->theta = 0;
    teleport_->async_send_request(
      place, [then](rclcpp::Client<TeleportAbsolute>::SharedFuture) {then();});
  }

  template<typename ThenT>
  void clear(ThenT then)
  {
    clear_->async_send_request(
      std::make_shared<Empty::Request>(), [then](rclcpp::Client<Empty>::SharedFuture) {then();});
  }

  std::size_t number_ = 0;
  bool is_drawing_ = false;
  bool is_yours_ = false;
  double turned_ = 0;
  double heading_ = 0;
  rclcpp::Publisher<Twist>::SharedPtr publisher_;
  rclcpp::Client<SetPen>::SharedPtr pen_;
  rclcpp::Client<TeleportAbsolute>::SharedPtr teleport_;
  rclcpp::Client<Empty>::SharedPtr clear_;
  rclcpp::Subscription<Pose>::SharedPtr poses_;
  rclcpp::Subscription<Twist>::SharedPtr others_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Spirograph>());
  rclcpp::shutdown();
  return 0;
}
