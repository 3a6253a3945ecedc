// An interactive marker, served as upstream's library does, and a camera in the same frame.
#include <chrono>
#include <cmath>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
#include "sensor_msgs/msg/image.hpp"
#include "visualization_msgs/msg/interactive_marker_feedback.hpp"
#include "visualization_msgs/msg/interactive_marker_update.hpp"
#include "visualization_msgs/srv/get_interactive_markers.hpp"

using namespace std::chrono_literals;
using sensor_msgs::msg::CameraInfo;
using sensor_msgs::msg::Image;
using visualization_msgs::msg::InteractiveMarker;
using visualization_msgs::msg::InteractiveMarkerControl;
using visualization_msgs::msg::InteractiveMarkerFeedback;
using visualization_msgs::msg::InteractiveMarkerPose;
using visualization_msgs::msg::InteractiveMarkerUpdate;
using visualization_msgs::msg::Marker;
using visualization_msgs::msg::MenuEntry;
using visualization_msgs::srv::GetInteractiveMarkers;

class Knob : public rclcpp::Node
{
public:
  Knob()
  : Node("knob")
  {
    marker_.header.frame_id = "map";
    marker_.name = "knob";
    marker_.scale = 1.0F;
    marker_.pose.orientation.w = 1.0;
    control("slide", InteractiveMarkerControl::MOVE_AXIS, 1.0, 0.0);
    // Around z.
    control("turn", InteractiveMarkerControl::ROTATE_AXIS, std::sqrt(0.5), -std::sqrt(0.5));
    Marker ball;
    ball.type = Marker::SPHERE;
    ball.pose.orientation.w = 1.0;
    ball.scale.x = ball.scale.y = ball.scale.z = 0.4;
    ball.color.r = ball.color.a = 1.0F;
    control("press", InteractiveMarkerControl::BUTTON, 1.0, 0.0).markers.push_back(ball);
    entry(1, 0, "Reset");
    entry(2, 0, "More");
    entry(3, 2, "Deep");
    service_ = create_service<GetInteractiveMarkers>(
      "knob/get_interactive_markers",
      [this](GetInteractiveMarkers::Request::SharedPtr, GetInteractiveMarkers::Response::SharedPtr response) {
        response->sequence_number = sequence_;
        response->markers.push_back(marker_);
      });
    subscription_ = create_subscription<InteractiveMarkerFeedback>(
      "knob/feedback", 10, [this](const InteractiveMarkerFeedback & feedback) {hear(feedback);});
    timer_ = create_wall_timer(500ms, [this] {film();});
  }

private:
  InteractiveMarkerControl & control(const std::string & name, unsigned char mode, double w, double y)
  {
    InteractiveMarkerControl control;
    control.name = name;
    control.interaction_mode = mode;
    control.orientation.w = w;
    control.orientation.y = y;
    marker_.controls.push_back(control);
    return marker_.controls.back();
  }

  void entry(unsigned int id, unsigned int parent, const std::string & title)
  {
    MenuEntry entry;
    entry.id = id;
    entry.parent_id = parent;
    entry.title = title;
    entry.command_type = MenuEntry::FEEDBACK;
    marker_.menu_entries.push_back(entry);
  }

  void hear(const InteractiveMarkerFeedback & feedback)
  {
    const auto & control = feedback.control_name;
    switch (feedback.event_type) {
      case InteractiveMarkerFeedback::MOUSE_DOWN:
        RCLCPP_INFO(get_logger(), "down %s", control.c_str());
        break;
      case InteractiveMarkerFeedback::MOUSE_UP:
        RCLCPP_INFO(
          get_logger(), "up %s at %.2f %.2f, turned %.0f", control.c_str(), marker_.pose.position.x,
          marker_.pose.position.y,
          std::atan2(marker_.pose.orientation.z, marker_.pose.orientation.w) * 360 / M_PI);
        break;
      case InteractiveMarkerFeedback::BUTTON_CLICK:
        RCLCPP_INFO(get_logger(), "click %s", control.c_str());
        break;
      case InteractiveMarkerFeedback::MENU_SELECT:
        RCLCPP_INFO(get_logger(), "menu %u", feedback.menu_entry_id);
        if (feedback.menu_entry_id == 1) {move(geometry_msgs::msg::Pose());}
        break;
      case InteractiveMarkerFeedback::POSE_UPDATE:
        move(feedback.pose);
        break;
      default:
        break;
    }
  }

  void move(const geometry_msgs::msg::Pose & pose)
  {
    marker_.pose = pose;
    InteractiveMarkerPose moved;
    moved.header = marker_.header;
    moved.name = marker_.name;
    moved.pose = pose;
    InteractiveMarkerUpdate update;
    update.type = InteractiveMarkerUpdate::UPDATE;
    update.seq_num = ++sequence_;
    update.poses.push_back(moved);
    update_->publish(update);
  }

  // Looks along z of the frame: red on the left, blue on the right.
  void film()
  {
    Image image;
    image.header.frame_id = "map";
    image.width = 2;
    image.height = 2;
    image.encoding = "rgb8";
    image.step = 6;
    image.data = {255, 0, 0, 0, 0, 255, 255, 0, 0, 0, 0, 255};
    CameraInfo info;
    info.header.frame_id = "map";
    info.width = info.height = 2;
    info.k = {1, 0, 1, 0, 1, 1, 0, 0, 1};
    info_->publish(info);
    image_->publish(image);
  }

  InteractiveMarker marker_;
  std::uint64_t sequence_ = 0;
  rclcpp::Publisher<InteractiveMarkerUpdate>::SharedPtr update_ =
    create_publisher<InteractiveMarkerUpdate>("knob/update", 100);
  rclcpp::Publisher<Image>::SharedPtr image_ = create_publisher<Image>("front/image_raw", 10);
  rclcpp::Publisher<CameraInfo>::SharedPtr info_ = create_publisher<CameraInfo>("front/camera_info", 10);
  rclcpp::Service<GetInteractiveMarkers>::SharedPtr service_;
  rclcpp::Subscription<InteractiveMarkerFeedback>::SharedPtr subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Knob>());
  rclcpp::shutdown();
}
