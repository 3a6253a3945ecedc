// Publishes the positions of all joints of the robot on /robot_description: those received from
// other topics (`source_list`), else zero, or the middle of the range if it does not contain zero.
#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "robot_model/robot_model.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "std_msgs/msg/string.hpp"

using sensor_msgs::msg::JointState;
using std_msgs::msg::String;

class JointStatePublisher : public rclcpp::Node
{
public:
  JointStatePublisher()
  : Node("joint_state_publisher")
  {
    const auto text = declare_parameter("robot_description", std::string());
    const auto rate = declare_parameter("rate", 10);
    const auto sources = declare_parameter("source_list", std::vector<std::string>());
    publisher_ = create_publisher<JointState>("joint_states", 10);
    if (!text.empty()) {
      set_up(text);
    } else {
      RCLCPP_INFO(
        get_logger(), "Waiting for robot_description to be published on the robot_description "
        "topic...");
    }
    description_ = create_subscription<String>(
      "robot_description", rclcpp::QoS(1).transient_local(),
      [this](String::ConstSharedPtr message) {set_up(message->data);});
    for (const std::string & source : sources) {
      sources_.push_back(
        create_subscription<JointState>(
          source, 10, [this](JointState::ConstSharedPtr state) {take(*state);}));
    }
    timer_ = create_wall_timer(
      std::chrono::nanoseconds(1000000000 / std::max<std::int64_t>(rate, 1)),
      [this]() {publish();});
  }

private:
  void set_up(const std::string & text)
  {
    try {
      model_ = robot_model::parse_urdf(text);
    } catch (const std::runtime_error & error) {
      RCLCPP_WARN(get_logger(), "Invalid robot_description given, ignoring: %s", error.what());
      return;
    }
    positions_.clear();
    for (const auto & [name, joint] : model_.joints) {
      if (joint.moves() && !joint.mimic) {
        const bool zero = joint.type == "continuous" || (joint.lower <= 0 && joint.upper >= 0);
        positions_[name] = zero ? 0 : (joint.lower + joint.upper) / 2;
      }
    }
  }

  void take(const JointState & state)
  {
    for (std::size_t i = 0; i < std::min(state.name.size(), state.position.size()); ++i) {
      const auto known = positions_.find(state.name[i]);
      if (known != positions_.end()) {known->second = state.position[i];}
    }
  }

  void publish()
  {
    JointState state;
    state.header.stamp = now();
    for (const std::string & name : model_.order) {
      const auto & joint = model_.joints.at(name);
      const auto own = positions_.find(joint.mimic ? joint.mimic->joint : name);
      if (!joint.moves() || own == positions_.end()) {continue;}
      const double multiplier = joint.mimic ? joint.mimic->multiplier : 1;
      const double offset = joint.mimic ? joint.mimic->offset : 0;
      state.name.push_back(name);
      state.position.push_back(own->second * multiplier + offset);
    }
    if (!state.name.empty()) {publisher_->publish(state);}
  }

  robot_model::Model model_{};
  std::map<std::string, double> positions_;
  rclcpp::Publisher<JointState>::SharedPtr publisher_;
  rclcpp::Subscription<String>::SharedPtr description_;
  std::vector<rclcpp::Subscription<JointState>::SharedPtr> sources_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<JointStatePublisher>());
  rclcpp::shutdown();
  return 0;
}
