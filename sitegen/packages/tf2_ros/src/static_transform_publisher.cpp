// static_transform_publisher --x 1 --yaw 1.57 --frame-id world --child-frame-id map
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Quaternion.hpp"
#include "tf2_ros/static_transform_broadcaster.hpp"

namespace
{

constexpr const char * kUsage =
  "usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] "
  "[--qw QW] [--roll ROLL] [--pitch PITCH] [--yaw YAW] --frame-id FRAME_ID "
  "--child-frame-id CHILD_FRAME_ID\n"
  "Lengths are in meters, angles in radians.";
/// The options and their defaults.
const std::map<std::string, double> kNumbers{
  {"x", 0}, {"y", 0}, {"z", 0}, {"qx", 0}, {"qy", 0}, {"qz", 0}, {"qw", 1},
  {"roll", 0}, {"pitch", 0}, {"yaw", 0}};

struct Given
{
  std::map<std::string, double> numbers;
  std::string frame;
  std::string child;

  double number(const char * name) const
  {
    const auto found = numbers.find(name);
    return found == numbers.end() ? kNumbers.at(name) : found->second;
  }
  bool any_of(std::initializer_list<const char *> names) const
  {
    for (const char * name : names) {
      if (numbers.count(name)) {return true;}
    }
    return false;
  }
  tf2::Quaternion rotation() const
  {
    tf2::Quaternion q(number("qx"), number("qy"), number("qz"), number("qw"));
    if (any_of({"roll", "pitch", "yaw"})) {
      q.setRPY(number("roll"), number("pitch"), number("yaw"));
    }
    return q;
  }
};

double to_number(const std::string & name, const std::string & text)
{
  try {
    return std::stod(text);
  } catch (const std::invalid_argument &) {
    throw std::invalid_argument("Failed to parse " + name + " argument as float");
  }
}

/// x y z yaw pitch roll frame child, or x y z qx qy qz qw frame child.
void parse_old(const std::vector<std::string> & words, Given & given)
{
  std::vector<std::string> names{"x", "y", "z", "yaw", "pitch", "roll"};
  if (words.size() == 9) {names = {"x", "y", "z", "qx", "qy", "qz", "qw"};}
  RCLCPP_WARN(
    rclcpp::get_logger(""),
    "Old-style arguments are deprecated; see --help for new-style arguments");
  for (std::size_t i = 0; i < names.size(); ++i) {
    given.numbers[names[i]] = to_number(names[i], words[i]);
  }
  given.frame = words[words.size() - 2];
  given.child = words.back();
}

/// Throws std::invalid_argument.
Given parse(const std::vector<std::string> & arguments)
{
  Given given;
  std::vector<std::string> plain;
  bool flags = false;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string & word = arguments[i];
    const std::string name = word.rfind("--", 0) == 0 ? word.substr(2) : "";
    const bool text = name == "frame-id" || name == "child-frame-id";
    if (!text && !kNumbers.count(name)) {
      plain.push_back(word);
      continue;
    }
    flags = true;
    if (++i == arguments.size()) {
      throw std::invalid_argument("Not enough arguments for " + word);
    }
    if (text) {
      (name == "frame-id" ? given.frame : given.child) = arguments[i];
    } else {
      given.numbers[name] = to_number(word, arguments[i]);
    }
  }
  if (given.any_of({"roll", "pitch", "yaw"}) && given.any_of({"qx", "qy", "qz", "qw"})) {
    throw std::invalid_argument("Cannot specify both quaternion and Euler rotations");
  }
  if (plain.size() == 8 || plain.size() == 9) {
    if (flags) {
      throw std::invalid_argument(
              "Cannot specify both new-style (flags) and old-style (arguments)");
    }
    parse_old(plain, given);
  } else if (!plain.empty()) {
    throw std::invalid_argument("Extra unparsed arguments on command-line");
  }
  if (given.frame.empty()) {throw std::invalid_argument("Frame id must not be empty");}
  if (given.child.empty()) {throw std::invalid_argument("Child frame id must not be empty");}
  return given;
}

/// Publishes one transform, once; it is transient local, so late subscribers receive it, too.
class StaticTransformPublisher : public rclcpp::Node
{
public:
  explicit StaticTransformPublisher(const Given & given)
  : Node("static_transform_publisher"), broadcaster_(*this)
  {
    const tf2::Quaternion q = given.rotation();
    geometry_msgs::msg::TransformStamped message;
    message.header.stamp = now();
    message.header.frame_id = given.frame;
    message.child_frame_id = given.child;
    message.transform.translation.x = given.number("x");
    message.transform.translation.y = given.number("y");
    message.transform.translation.z = given.number("z");
    message.transform.rotation.x = q.x();
    message.transform.rotation.y = q.y();
    message.transform.rotation.z = q.z();
    message.transform.rotation.w = q.w();
    if (given.frame == given.child) {
      RCLCPP_ERROR(
        get_logger(), "cannot publish static transform from '%s' to '%s', exiting",
        given.frame.c_str(), given.child.c_str());
      throw std::runtime_error("child_frame_id cannot equal frame_id");
    }
    broadcaster_.sendTransform(message);
    RCLCPP_INFO(
      get_logger(),
      "Spinning until stopped - publishing transform\ntranslation: ('%lf', '%lf', '%lf')\n"
      "rotation: ('%lf', '%lf', '%lf', '%lf')\nfrom '%s' to '%s'",
      given.number("x"), given.number("y"), given.number("z"), q.x(), q.y(), q.z(), q.w(),
      given.frame.c_str(), given.child.c_str());
  }

private:
  tf2_ros::StaticTransformBroadcaster broadcaster_;
};

}  // namespace

int main(int argc, char ** argv)
{
  const auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  for (const std::string & word : arguments) {
    if (word == "--help" || word == "-h") {
      std::printf("%s\n", kUsage);
      return 0;
    }
  }
  Given given;
  try {
    given = parse(arguments);
  } catch (const std::invalid_argument & error) {
    RCLCPP_ERROR(
      rclcpp::get_logger(""), "error parsing command line arguments: %s", error.what());
    std::printf("%s\n", kUsage);
    return 1;
  }
  rclcpp::spin(std::make_shared<StaticTransformPublisher>(given));
  rclcpp::shutdown();
  return 0;
}
