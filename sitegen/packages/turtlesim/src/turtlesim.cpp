// Turtles that draw in a window of the page, which receives ~/window.
#include <chrono>
#include <map>
#include <memory>
#include <string>

#include "canvas.hpp"
#include "interfaces.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_srvs/srv/empty.hpp"
#include "turtle.hpp"
#include "turtlesim_window/msg/window.hpp"

using std_srvs::srv::Empty;
using interfaces::srv::Kill;
using interfaces::srv::Spawn;
using turtlesim_window::msg::Window;

class Turtlesim : public rclcpp::Node
{
public:
  Turtlesim()
  : Node("turtlesim")
  {
    declare_color("background_r", 69);
    declare_color("background_g", 86);
    declare_color("background_b", 255);
    rcl_interfaces::msg::ParameterDescriptor holonomic;
    holonomic.description = "If true, then turtles will be holonomic";
    declare_parameter("holonomic", false, holonomic);
    window_ = create_publisher<Window>("~/window", rclcpp::QoS(1).transient_local());
    serve();
    RCLCPP_INFO(
      get_logger(), "Starting turtlesim with node name %s", get_fully_qualified_name());
    begin();
    timer_ = create_wall_timer(FRAME, [this]() {update();});
  }

private:
  static constexpr std::chrono::milliseconds FRAME{16};

  void declare_color(const std::string & name, int value)
  {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = "Channel of the background color";
    descriptor.integer_range.resize(1);
    descriptor.integer_range[0].from_value = 0;
    descriptor.integer_range[0].to_value = 255;
    descriptor.integer_range[0].step = 1;
    declare_parameter(name, value, descriptor);
  }

  void serve()
  {
    clear_ = create_service<Empty>(
      "clear", [this](Empty::Request::SharedPtr, Empty::Response::SharedPtr) {
        RCLCPP_INFO(get_logger(), "Clearing turtlesim.");
        clear();
      });
    reset_ = create_service<Empty>(
      "reset", [this](Empty::Request::SharedPtr, Empty::Response::SharedPtr) {
        RCLCPP_INFO(get_logger(), "Resetting turtlesim.");
        turtles_.clear();
        named_ = 0;
        begin();
      });
    spawn_ = create_service<Spawn>(
      "spawn", [this](Spawn::Request::SharedPtr asked, Spawn::Response::SharedPtr answer) {
        answer->name = spawn(asked->name, {asked->x, asked->y}, asked->theta);
      });
    kill_ = create_service<Kill>(
      "kill", [this](Kill::Request::SharedPtr asked, Kill::Response::SharedPtr) {
        if (turtles_.erase(asked->name) == 0) {
          RCLCPP_ERROR(
            get_logger(), "Tried to kill turtle [%s], which does not exist", asked->name.c_str());
        }
        show();
      });
  }

  void begin()
  {
    constexpr auto middle = static_cast<float>(Canvas::EXTENT / 2);  // as precise as the service
    spawn("", {middle, middle}, 0);
    clear();
  }

  // Returns the name, which is empty if there is such a turtle already.
  std::string spawn(std::string name, Point place, double heading)
  {
    if (turtles_.count(name)) {
      RCLCPP_ERROR(get_logger(), "A turtle named [%s] already exists", name.c_str());
      return "";
    }
    while (name.empty() || turtles_.count(name)) {name = "turtle" + std::to_string(++named_);}
    turtles_[name] = std::make_unique<Turtle>(
      *this, name, ++spawned_, place, heading, [this]() {show();});
    RCLCPP_INFO(
      get_logger(), "Spawning turtle [%s] at x=[%f], y=[%f], theta=[%f]", name.c_str(), place.x,
      place.y, heading);
    show();
    return name;
  }

  void clear()
  {
    background_ = {channel("background_r"), channel("background_g"), channel("background_b")};
    canvas_.fill(background_);
    ++cleared_;
    show();
  }

  std::uint8_t channel(const std::string & name)
  {
    return static_cast<std::uint8_t>(get_parameter(name).as_int());
  }

  void update()
  {
    for (const auto & [name, turtle] : turtles_) {
      turtle->update(std::chrono::duration<double>(FRAME).count(), canvas_);
    }
  }

  void show()
  {
    Window window;
    window.background_r = background_.r;
    window.background_g = background_.g;
    window.background_b = background_.b;
    window.cleared = cleared_;
    window.reset = reset_->get_service_name();
    for (const auto & [name, turtle] : turtles_) {window.turtles.push_back(turtle->look());}
    window_->publish(window);
  }

  Canvas canvas_;
  Rgb background_{};
  std::uint32_t cleared_ = 0;
  std::map<std::string, std::unique_ptr<Turtle>> turtles_;
  int named_ = 0;
  std::uint32_t spawned_ = 0;
  rclcpp::Publisher<Window>::SharedPtr window_;
  rclcpp::Service<Empty>::SharedPtr clear_;
  rclcpp::Service<Empty>::SharedPtr reset_;
  rclcpp::Service<Spawn>::SharedPtr spawn_;
  rclcpp::Service<Kill>::SharedPtr kill_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Turtlesim>());
  rclcpp::shutdown();
  return 0;
}
