// Names that published packages use beside those of the tutorials.
#include <chrono>
#include <map>
#include <memory>
#include <string>

#include <ament_index_cpp/get_package_share_path.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp/version.h>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <rcpputils/pointer_traits.hpp>
#include <std_msgs/msg/string.hpp>

using namespace std::chrono_literals;
using std_msgs::msg::String;

static_assert(RCLCPP_VERSION_GTE(28, 0, 0) && !RCLCPP_VERSION_GTE(99, 0, 0));
static_assert(!std::is_base_of_v<rclcpp::Node, rclcpp_lifecycle::LifecycleNode>);
static_assert(rcpputils::is_pointer<std::shared_ptr<int>>::value);

class Managed : public rclcpp_lifecycle::LifecycleNode
{
public:
  Managed()
  : LifecycleNode("managed") {}
  std::string itself() {return shared_from_this()->get_name();}
};

// A node of each kind has its own overload.
std::string kind(rclcpp::Node::SharedPtr) {return "node";}
std::string kind(rclcpp_lifecycle::LifecycleNode::SharedPtr) {return "lifecycle node";}

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const auto options = rclcpp::NodeOptions().automatically_declare_parameters_from_overrides(true)
    .parameter_overrides({{"arm.length", 2}, {"arm.name", "left"}});
  auto node = std::make_shared<rclcpp::Node>("edges", options);
  auto managed = std::make_shared<Managed>();
  const auto logger = node->get_logger();
  RCLCPP_INFO(
    logger, "%s, %s %s", kind(node).c_str(), kind(managed).c_str(), managed->itself().c_str());

  std::map<std::string, rclcpp::Parameter> parameters;
  node->get_parameters("arm", parameters);
  RCLCPP_INFO(
    logger, "%s %s", parameters.at("length").value_to_string().c_str(),
    parameters.at("name").get_value<rclcpp::Parameter>().as_string().c_str());

  try {
    throw rclcpp::exceptions::RCLInvalidArgument("refused");
  } catch (const std::invalid_argument & error) {
    RCLCPP_INFO(logger, "%s", error.what());
  }
  const rcl_time_point_value_t point = rclcpp::Time(rcl_time_point_t{7, RCL_ROS_TIME}).nanoseconds();
  const auto path = ament_index_cpp::get_package_share_path("robot_tools");
  RCLCPP_INFO(logger, "%d in %s", static_cast<int>(point), path.filename().c_str());

  auto interfaces = node->get_node_topics_interface();
  auto values = node->get_node_parameters_interface();
  auto publisher = rclcpp::create_publisher<String>(values, interfaces, "words", rclcpp::QoS(1));
  auto subscription = rclcpp::create_subscription<String>(
    values, interfaces, "words", rclcpp::QoS(1), [&](const String & message) {
      RCLCPP_INFO(logger, "heard %s", message.data.c_str());
      rclcpp::shutdown();
    });
  auto timer = rclcpp::WallTimer<rclcpp::VoidCallbackType>::make_shared(
    10ms, [&] {
      String message;
      message.data = "words";
      publisher->publish(message);
    }, node->get_node_base_interface()->get_context());
  node->get_node_timers_interface()->add_timer(timer, nullptr);
  rclcpp::spin(node);
  rclcpp::spin(std::make_unique<rclcpp::Node>("late", rclcpp::NodeOptions()));
}
