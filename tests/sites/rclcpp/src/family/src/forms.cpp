// The node in the other forms that packages use it in.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/type_adapter.hpp"
#include "rcpputils/join.hpp"
#include "rcutils/cmdline_parser.h"
#include "rcutils/logging_macros.h"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;

template<>
struct rclcpp::TypeAdapter<std::string, String>
{
  using is_specialized = std::true_type;
  using custom_type = std::string;
  using ros_message_type = String;

  static void convert_to_ros_message(const custom_type & from, ros_message_type & to)
  {
    to.data = from;
  }
  static void convert_to_custom(const ros_message_type & from, custom_type & to) {to = from.data;}
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("forms", "/space");
  auto sub = node->create_sub_node("part");
  std::printf("%s %s\n", sub->get_effective_namespace().c_str(), sub->get_name());

  using Adapted = rclcpp::TypeAdapter<std::string, String>;
  auto publisher = sub->create_publisher<Adapted>("words", 10);
  std::printf("%s\n", publisher->get_topic_name());
  std::vector<std::string> heard;
  auto custom = sub->create_subscription<Adapted>(
    "words", 10, [&](const std::string & word) {heard.push_back("custom " + word);});
  auto plain = node->create_subscription<String>(
    "part/words", 10, [&](String::UniquePtr word) {heard.push_back("plain " + word->data);});
  rclcpp::Serialization<String> serialization;
  auto generic = node->create_generic_subscription(
    "part/words", "std_msgs/msg/String", 10,
    [&](std::shared_ptr<const rclcpp::SerializedMessage> bytes) {
      String word;
      serialization.deserialize_message(bytes.get(), &word);
      heard.push_back("generic " + word.data);
    });
  auto sender = node->create_generic_publisher("part/words", "std_msgs/msg/String", 10);
  publisher->publish(std::string("one"));
  String two;
  two.data = "two";
  rclcpp::SerializedMessage bytes;
  serialization.serialize_message(&two, &bytes);
  sender->publish(bytes);
  auto loaned = node->create_publisher<String>("part/words", 10);
  auto message = loaned->borrow_loaned_message();
  message.get().data = "three";
  loaned->publish(std::move(message));
  while (heard.size() < 9) {rclcpp::spin_some(node);}
  std::printf("%s\n", rcpputils::join(heard, ", ").c_str());

  int calls = 0;
  auto timer = rclcpp::create_timer(
    node, node->get_clock(), rclcpp::Duration(1ms), [&] {++calls;});
  while (calls < 3) {rclcpp::spin_some(node);}
  timer->cancel();
  std::printf("timer %d\n", timer->is_canceled());

  std::ifstream file(ament_index_cpp::get_package_share_directory("family") + "/config/robot.yaml");
  std::string line;
  std::getline(file, line);
  std::printf("%s\n", line.c_str());
  try {
    ament_index_cpp::get_package_share_directory("nowhere");
  } catch (const ament_index_cpp::PackageNotFoundError & error) {
    std::printf("%s\n", error.what());
  }
  RCUTILS_LOG_INFO_NAMED("named", "logged %d", 1);
  std::printf(
    "option %d %s\n", rcutils_cli_option_exist(argv, argv + argc, "-x"),
    rcutils_cli_get_option(argv, argv + argc, "-t"));
}
