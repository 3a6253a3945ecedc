// Answers each line of its input: what it read from the bytes in it, written again.
#include "cdr_check.hpp"

#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "sensor_msgs/msg/image.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/joint_state.hpp"
#include "sensor_msgs/msg/joy.hpp"
#include "sensor_msgs/msg/laser_scan.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "shape_msgs/msg/mesh.hpp"
#include "shape_msgs/msg/solid_primitive.hpp"
#include "std_msgs/msg/color_rgba.hpp"
#include "std_msgs/msg/float64_multi_array.hpp"
#include "std_msgs/msg/header.hpp"
#include "std_msgs/msg/string.hpp"
#include "test_msgs/action/fibonacci.hpp"
#include "test_msgs/action/nested_message.hpp"
#include "test_msgs/msg/arrays.hpp"
#include "test_msgs/msg/basic_types.hpp"
#include "test_msgs/msg/bounded_plain_sequences.hpp"
#include "test_msgs/msg/bounded_sequences.hpp"
#include "test_msgs/msg/builtins.hpp"
#include "test_msgs/msg/complex_nested_key.hpp"
#include "test_msgs/msg/constants.hpp"
#include "test_msgs/msg/defaults.hpp"
#include "test_msgs/msg/empty.hpp"
#include "test_msgs/msg/keyed_string.hpp"
#include "test_msgs/msg/multi_nested.hpp"
#include "test_msgs/msg/nested.hpp"
#include "test_msgs/msg/strings.hpp"
#include "test_msgs/msg/unbounded_sequences.hpp"
#include "test_msgs/msg/w_strings.hpp"
#include "test_msgs/srv/arrays.hpp"
#include "test_msgs/srv/basic_types.hpp"
#include "test_msgs/srv/empty.hpp"

namespace
{

using Types = std::map<std::string, const MessageMembers *>;

template<class ... Message>
Types types_of()
{
  Types types;
  for (const auto * type : {&rosidl_typesupport_sitegen_cpp::members_of<Message>()...}) {
    types[type->name] = type;
  }
  return types;
}

Types all_types()
{
  using namespace test_msgs;  // NOLINT
  return types_of<
    geometry_msgs::msg::PoseWithCovarianceStamped, geometry_msgs::msg::TransformStamped,
    sensor_msgs::msg::Image, sensor_msgs::msg::Imu, sensor_msgs::msg::JointState,
    sensor_msgs::msg::Joy, sensor_msgs::msg::LaserScan, sensor_msgs::msg::PointCloud2,
    shape_msgs::msg::Mesh, shape_msgs::msg::SolidPrimitive,
    std_msgs::msg::ColorRGBA, std_msgs::msg::Float64MultiArray, std_msgs::msg::Header,
    std_msgs::msg::String,
    msg::Arrays, msg::BasicTypes, msg::BoundedPlainSequences, msg::BoundedSequences,
    msg::Builtins, msg::ComplexNestedKey, msg::Constants, msg::Defaults, msg::Empty,
    msg::KeyedString, msg::MultiNested, msg::Nested, msg::Strings, msg::UnboundedSequences,
    msg::WStrings,
    srv::Arrays::Request, srv::Arrays::Response, srv::BasicTypes::Request,
    srv::BasicTypes::Response, srv::Empty::Request, srv::Empty::Response,
    action::Fibonacci::Goal, action::Fibonacci::Result, action::Fibonacci::Feedback,
    action::Fibonacci::Impl::SendGoalService::Request,
    action::Fibonacci::Impl::SendGoalService::Response,
    action::Fibonacci::Impl::GetResultService::Response,
    action::Fibonacci::Impl::FeedbackMessage, action::NestedMessage::Impl::FeedbackMessage>();
}

Bytes from_hex(const std::string & text)
{
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

std::string to_hex(const Bytes & bytes)
{
  std::string text;
  for (const auto byte : bytes) {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

/// Whether a text longer than its type allows is refused when it is written.
std::string too_long()
{
  test_msgs::msg::Strings strings;
  strings.bounded_string_value.assign(23, 'x');
  const auto & type = rosidl_typesupport_sitegen_cpp::members_of<test_msgs::msg::Strings>();
  return std::to_string(serialized_size(type, &strings));
}

std::string answer(const Types & types, const std::string & line)
{
  std::istringstream words(line);
  std::string command, name, hex;
  words >> command;
  if (command == "types") {
    std::string names;
    for (const auto & type : types) {names += type.first + " ";}
    return names;
  }
  if (command == "too_long") {return too_long();}
  words >> name >> hex;
  const MessageMembers & type = *types.at(name);
  const Bytes bytes = from_hex(hex);
  if (command == "fuzz") {
    std::uint32_t seed;
    unsigned count;
    words >> seed >> count;
    return fuzz(type, bytes, seed, count);
  }
  Message message(type);
  if (command == "again" && !message.read(bytes.data(), bytes.size())) {return "refused";}
  return to_hex(message.write());
}

}  // namespace

int main()
{
  const Types types = all_types();
  for (std::string line; std::getline(std::cin, line); ) {
    try {
      std::cout << answer(types, line) << std::endl;
    } catch (const std::exception & error) {
      std::cout << "error: " << error.what() << std::endl;
    }
  }
}
