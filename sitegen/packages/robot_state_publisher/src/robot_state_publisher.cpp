// Publishes the description of a robot and the transforms of its links: fixed ones on /tf_static, others
// on /tf for each message on /joint_states.
#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "robot_model/robot_model.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "std_msgs/msg/string.hpp"
#include "tf2_ros/static_transform_broadcaster.hpp"
#include "tf2_ros/transform_broadcaster.hpp"

using geometry_msgs::msg::TransformStamped;
using robot_model::Joint;
using sensor_msgs::msg::JointState;
using std_msgs::msg::String;

class RobotStatePublisher : public rclcpp::Node
{
public:
  RobotStatePublisher()
  : Node("robot_state_publisher"), moving_(*this), fixed_(*this)
  {
    const bool from_topic = declare_parameter("use_robot_description_topic", false);
    const std::string text = from_topic ? "" : declare_parameter("robot_description", std::string());
    if (!from_topic && text.empty()) {
      throw std::runtime_error("robot_description parameter must not be empty");
    }
    frequency_ = declare_parameter("publish_frequency", 20.0);
    if (!is_frequency(frequency_)) {
      throw std::runtime_error("publish_frequency must be between 0 (exclusive) and 1000");
    }
    prefix_ = declare_parameter("frame_prefix", std::string());
    ignore_timestamp_ = declare_parameter("ignore_timestamp", false);
    const auto kept = rclcpp::QoS(1).transient_local();
    if (from_topic) {
      description_subscription_ = create_subscription<String>(
        "robot_description", kept, [this](String::ConstSharedPtr message) {
          try {
            set_up(message->data);
          } catch (const std::exception & error) {
            RCLCPP_ERROR(
              get_logger(), "Failed to parse robot description from topic: %s", error.what());
          }
        });
    } else {
      description_ = create_publisher<String>("robot_description", kept);
      set_up(text);
      check_ = add_on_set_parameters_callback(
        [this](const std::vector<rclcpp::Parameter> & changed) {return check(changed);});
      change_ = add_post_set_parameters_callback(
        [this](const std::vector<rclcpp::Parameter> & changed) {change(changed);});
    }
    joint_states_ = create_subscription<JointState>(
      "joint_states", rclcpp::SensorDataQoS(),
      [this](JointState::ConstSharedPtr state) {take(*state);});
  }

private:
  static bool is_frequency(double value) {return value > 0.0 && value <= 1000.0;}

  robot_model::Model parse(const std::string & text) const
  {
    try {
      auto model = robot_model::parse_urdf(text);
      if (model.root_has_inertia) {
        RCLCPP_WARN(
          rclcpp::get_logger("kdl_parser"),
          "The root link %s has an inertia specified in the URDF, but KDL does not support a root "
          "link with an inertia.  As a workaround, you can add an extra dummy link to your URDF.",
          model.root.c_str());
      }
      return model;
    } catch (const std::runtime_error & error) {
      RCLCPP_ERROR(get_logger(), "%s", error.what());
      throw std::runtime_error("Unable to initialize urdf::model from robot description");
    }
  }

  void set_up(const std::string & text)
  {
    const auto model = parse(text);
    joints_ = model.joints;
    if (description_) {
      String message;
      message.data = text;
      description_->publish(message);
    }
    RCLCPP_INFO(get_logger(), "Robot initialized");
    publish_fixed();
  }

  TransformStamped transform(
    const Joint & joint, double position, const builtin_interfaces::msg::Time & stamp) const
  {
    const tf2::Transform pose = joint.pose(position);
    const tf2::Quaternion rotation = pose.getRotation();
    TransformStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = prefix_ + joint.parent;
    message.child_frame_id = prefix_ + joint.child;
    message.transform.translation.x = pose.getOrigin().x();
    message.transform.translation.y = pose.getOrigin().y();
    message.transform.translation.z = pose.getOrigin().z();
    message.transform.rotation.x = rotation.x();
    message.transform.rotation.y = rotation.y();
    message.transform.rotation.z = rotation.z();
    message.transform.rotation.w = rotation.w();
    return message;
  }

  void publish_fixed()
  {
    std::vector<TransformStamped> transforms;
    const rclcpp::Time stamp = now();
    for (const auto & [name, joint] : joints_) {
      if (!joint.moves() && joint.type != "floating") {
        transforms.push_back(transform(joint, 0, stamp));
      }
    }
    fixed_.sendTransform(transforms);
  }

  void take(const JointState & state)
  {
    if (state.name.size() != state.position.size()) {
      if (state.position.empty()) {
        RCLCPP_WARN(
          get_logger(), "Robot state publisher ignored a JointState message about joint(s) "
          "\"%s\"(,...) whose position member was empty.", state.name[0].c_str());
      } else {
        RCLCPP_ERROR(
          get_logger(), "Robot state publisher ignored an invalid JointState message");
      }
      return;
    }
    const std::int64_t time = now().nanoseconds();
    if (time < last_time_) {
      RCLCPP_WARN(get_logger(), "Moved backwards in time, re-publishing joint transforms!");
      published_.clear();
    }
    last_time_ = time;
    // The rate is limited by the joint whose last publication is the oldest.
    std::int64_t oldest = time;
    for (const std::string & name : state.name) {oldest = std::min(oldest, published_[name]);}
    const auto period = static_cast<std::int64_t>(1000.0 / frequency_) * 1000000;
    const std::int64_t stamp = rclcpp::Time(state.header.stamp).nanoseconds();
    if (!ignore_timestamp_ && stamp < oldest + period) {return;}
    publish_moving(state);
    for (const std::string & name : state.name) {published_[name] = stamp;}
  }

  void publish_moving(const JointState & state)
  {
    std::map<std::string, double> positions;
    for (std::size_t i = 0; i < state.name.size(); ++i) {
      positions.emplace(state.name[i], state.position[i]);
    }
    for (const auto & [name, joint] : joints_) {
      const auto other = joint.mimic ? positions.find(joint.mimic->joint) : positions.end();
      if (other != positions.end()) {
        positions.emplace(name, other->second * joint.mimic->multiplier + joint.mimic->offset);
      }
    }
    std::vector<TransformStamped> transforms;
    for (const auto & [name, position] : positions) {
      const auto joint = joints_.find(name);
      if (joint != joints_.end() && joint->second.moves()) {
        transforms.push_back(transform(joint->second, position, state.header.stamp));
      }
    }
    moving_.sendTransform(transforms);
  }

  rcl_interfaces::msg::SetParametersResult check(
    const std::vector<rclcpp::Parameter> & changed) const
  {
    rcl_interfaces::msg::SetParametersResult result;
    for (const rclcpp::Parameter & each : changed) {
      if (each.get_name() == "robot_description" && each.as_string().empty()) {
        result.reason = "Empty URDF is not allowed";
      } else if (each.get_name() == "robot_description") {
        try {
          parse(each.as_string());
        } catch (const std::runtime_error & error) {
          RCLCPP_WARN(get_logger(), "%s", error.what());
          result.reason = error.what();
        }
      } else if (each.get_name() == "publish_frequency" && !is_frequency(each.as_double())) {
        result.reason = "publish_frequency must be between 0.0 (exclusive) and 1000.0";
      }
    }
    result.successful = result.reason.empty();
    return result;
  }

  void change(const std::vector<rclcpp::Parameter> & changed)
  {
    for (const rclcpp::Parameter & each : changed) {
      if (each.get_name() == "robot_description") {
        set_up(each.as_string());
      } else if (each.get_name() == "publish_frequency") {
        frequency_ = each.as_double();
      } else if (each.get_name() == "frame_prefix") {
        prefix_ = each.as_string();
      } else if (each.get_name() == "ignore_timestamp") {
        ignore_timestamp_ = each.as_bool();
      }
    }
  }

  tf2_ros::TransformBroadcaster moving_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  double frequency_ = 0;
  std::string prefix_;
  bool ignore_timestamp_ = false;
  std::map<std::string, Joint> joints_;
  std::map<std::string, std::int64_t> published_;  // when, in nanoseconds, by joint
  std::int64_t last_time_ = 0;
  rclcpp::Publisher<String>::SharedPtr description_;
  rclcpp::Subscription<String>::SharedPtr description_subscription_;
  rclcpp::Subscription<JointState>::SharedPtr joint_states_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr check_;
  rclcpp::node_interfaces::PostSetParametersCallbackHandle::SharedPtr change_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<RobotStatePublisher>());
  rclcpp::shutdown();
  return 0;
}
