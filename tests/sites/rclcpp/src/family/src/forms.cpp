// The node in the other forms that packages use it in.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "ament_index_cpp/get_packages_with_prefixes.hpp"
#include "ament_index_cpp/get_resource.hpp"
#include "components/shape.hpp"
#include "pluginlib/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/type_adapter.hpp"
#include "rcpputils/env.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "rcpputils/find_and_replace.hpp"
#include "rcpputils/join.hpp"
#include "rcpputils/rolling_mean_accumulator.hpp"
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

void load_plugins()
{
  pluginlib::ClassLoader<components::Shape> loader("components", "components::Shape");
  for (const auto & name : loader.getDeclaredClasses()) {
    std::printf(
      "%s is a %s of %s: %s\n", name.c_str(), loader.getClassType(name).c_str(),
      loader.getClassPackage(name).c_str(), loader.getClassDescription(name).c_str());
    try {
      std::shared_ptr<components::Shape> shape = loader.createSharedInstance(name);
      shape->initialize(3);
      std::printf("area %.0f\n", shape->area());
    } catch (const pluginlib::CreateClassException & error) {
      std::printf("%s\n", error.what());
    }
  }
  try {
    loader.createUniqueInstance("triangle");
  } catch (const pluginlib::LibraryLoadException & error) {
    std::printf("%s\n", error.what());
  }
}

void use_files()
{
  namespace fs = rcpputils::fs;
  const fs::path folder = fs::create_temp_directory("bag");
  const fs::path file = folder / "one.tar.gz";
  std::printf("there %d", fs::exists(file));
  std::ofstream(file.string()) << "12345";
  std::printf(
    " %d %d %d, %d bytes, %s %s %s\n", file.exists(), file.is_regular_file(),
    fs::is_directory(file.parent_path()), static_cast<int>(fs::file_size(file)),
    file.filename().string().c_str(), file.extension().string().c_str(),
    fs::remove_extension(file, 2).filename().string().c_str());
  std::printf(
    "made %d %d, ", fs::create_directories(folder / "a" / "b"), fs::create_directories(file / "c"));
  const bool removed = fs::remove(file);
  const bool again = fs::remove(file);
  std::printf("removed %d %d %d\n", removed, again, fs::remove_all(folder));
}

void filter(const rclcpp::Node::SharedPtr & node)
{
  rclcpp::SubscriptionOptions options;
  options.content_filter_options.filter_expression = "data = %0 OR NOT data LIKE 'a%'";
  options.content_filter_options.expression_parameters = {"'abc'"};
  std::string heard;
  auto subscription = node->create_subscription<String>(
    "filtered", 20, [&](const String & word) {heard += " " + word.data;}, options);
  auto publisher = node->create_publisher<String>("filtered", 20);
  const auto say_all = [&] {
      for (const char * word : {"a", "ab", "abc", "b", "last"}) {
        String message;
        message.data = word;
        publisher->publish(message);
      }
      while (heard.find("last") == std::string::npos) {rclcpp::spin_some(node);}
      std::printf("filter %d:%s\n", subscription->is_cft_enabled(), heard.c_str());
      heard.clear();
    };
  say_all();
  try {
    subscription->set_content_filter("date = 'b'");
  } catch (const rclcpp::exceptions::RCLError & error) {
    std::printf("%s\n", error.what());
  }
  std::printf("%s\n", subscription->get_content_filter().filter_expression.c_str());
  subscription->set_content_filter("data >= 'b'");
  say_all();
  subscription->set_content_filter("");
  say_all();
}

void ignore_own(const rclcpp::Node::SharedPtr & node)
{
  rclcpp::SubscriptionOptions options;
  options.ignore_local_publications = true;
  std::string heard;
  auto deaf = node->create_subscription<String>(
    "own", 20, [&](const String & word) {heard += " own " + word.data;}, options);
  auto plain = node->create_subscription<String>(
    "own", 20, [&](const String & word) {heard += " " + word.data;});
  auto publisher = node->create_publisher<String>("own", 20);
  for (const char * word : {"one", "two"}) {
    String message;
    message.data = word;
    publisher->publish(message);
  }
  while (heard.find("two") == std::string::npos) {rclcpp::spin_some(node);}
  String message;
  rclcpp::MessageInfo info;
  const bool took = deaf->take(message, info);
  std::printf("own:%s, %d, %zu\n", heard.c_str(), took, deaf->get_publisher_count());
}

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

  filter(node);
  ignore_own(node);
  load_plugins();
  use_files();

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
  std::string content = "?";
  const auto packages = ament_index_cpp::get_packages_with_prefixes();
  std::printf(
    "index %d %d %d%s\n", packages.count("family") == 1, packages.count("nowhere") == 1,
    ament_index_cpp::get_resource("packages", "family", content), content.c_str());
  rcpputils::RollingMeanAccumulator<double> mean(2);
  for (double number : {9.0, 2.0, 3.0}) {mean.accumulate(number);}
  rcpputils::set_env_var("ROBOT", "r-2-d-2");
  std::printf(
    "%s %.1f\n",
    rcpputils::find_and_replace(rcpputils::get_env_var("ROBOT"), "-", "").c_str(),
    mean.getRollingMean());
  for (int i = 0; i < 3; ++i) {
    RCUTILS_LOG_INFO_THROTTLE_NAMED(rcutils_steady_time_now, 60000, "named", "logged %d", i);
  }
  RCUTILS_LOG_INFO_NAMED("named", "logged %d", 1);
  std::printf(
    "option %d %s\n", rcutils_cli_option_exist(argv, argv + argc, "-x"),
    rcutils_cli_get_option(argv, argv + argc, "-t"));
}
