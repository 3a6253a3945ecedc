// Nodes of one program hand messages over, where they ask for it, and copy them where they do not.
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;
using namespace std::chrono_literals;

namespace
{

/// What was published and what is still held of it, so that no address is used twice.
const void * sent = nullptr;
std::vector<Int32::UniquePtr> owned;
std::vector<Int32::ConstSharedPtr> shared;

void tell(const char * who, const Int32 * got)
{
  std::printf("%s %d %s\n", who, got->data, got == sent ? "itself" : "a copy");
}

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("handing", rclcpp::NodeOptions().use_intra_process_comms(true));
  auto plain = rclcpp::Node::make_shared("plain");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.add_node(plain);

  int got = 0;
  const auto take = [&](Int32::UniquePtr message) {
      tell("own", message.get());
      owned.push_back(std::move(message));
      ++got;
    };
  const auto look = [&](Int32::ConstSharedPtr message) {
      tell("shared", message.get());
      shared.push_back(message);
      ++got;
    };
  const auto publish = [&](rclcpp::Publisher<Int32> & publisher, int number, int readers) {
      auto message = std::make_unique<Int32>();
      message->data = number;
      sent = message.get();
      publisher.publish(std::move(message));
      // Where it was, if it is gone, something else is now.
      for (int i = 0; i < 8; ++i) {owned.push_back(std::make_unique<Int32>());}
      for (got = 0; got < readers; ) {executor.spin_once(5s);}
    };
  const auto matched = [&](const rclcpp::PublisherBase & publisher, std::size_t readers) {
      while (publisher.get_subscription_count() < readers) {executor.spin_once(20ms);}
    };

  auto publisher = node->create_publisher<Int32>("numbers", 10);
  {
    auto one = node->create_subscription<Int32>("numbers", 10, take);
    matched(*publisher, 1);
    std::printf("%zu in this program\n", publisher->get_intra_process_subscription_count());
    publish(*publisher, 1, 1);
    auto two = node->create_subscription<Int32>("numbers", 10, look);
    auto three = node->create_subscription<Int32>(
      "numbers", 10, [&](const Int32 & message, const rclcpp::MessageInfo & info) {
        tell(info.get_rmw_message_info().from_intra_process ? "reference" : "?", &message);
        ++got;
      });
    matched(*publisher, 3);
    publish(*publisher, 2, 3);
  }
  std::printf("%zu in this program\n", publisher->get_intra_process_subscription_count());
  {
    auto one = plain->create_subscription<Int32>("numbers", 10, take);
    matched(*publisher, 1);
    publish(*publisher, 3, 1);
  }
  {
    rclcpp::SubscriptionOptions options;
    options.use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;
    auto one = node->create_subscription<Int32>("numbers", 10, look, options);
    matched(*publisher, 1);
    publish(*publisher, 4, 1);
  }
  rclcpp::PublisherOptions options;
  options.use_intra_process_comm = rclcpp::IntraProcessSetting::Enable;
  auto other = plain->create_publisher<Int32>("others", 10, options);
  auto last = node->create_subscription<Int32>("others", 10, look);
  matched(*other, 1);
  publish(*other, 5, 1);
  rclcpp::shutdown();
  return 0;
}
