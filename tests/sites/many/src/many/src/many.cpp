// Nodes as its arguments name them: "n:name" begins one, "p:/topic" and "s:/topic" are what it has,
// and "e:1000" how often the next ones publish, in milliseconds. They tell when they have heard
// enough of every publisher that is there, again when more have come, and go on.
#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using std_msgs::msg::String;

class Many : public rclcpp::Node
{
public:
  Many(const std::string & name, std::chrono::milliseconds period)
  : Node(name)
  {
    timer_ = create_wall_timer(period, [this]() {publish();});
  }

  void publish_on(const std::string & topic)
  {
    publishers_.push_back(create_publisher<String>(topic, 10));
  }

  void subscribe_to(const std::string & topic)
  {
    const auto index = heard_.size();
    heard_.emplace_back();
    subscriptions_.push_back(
      create_subscription<String>(
        topic, 10, [this, index](const String & message) {hear(heard_[index], message.data);}));
  }

private:
  // Three messages of each of so many publishers, in order, are enough of a topic.
  struct Heard
  {
    std::map<std::string, int> last;
    int count = 0;
  };

  void publish()
  {
    ++number_;
    for (std::size_t i = 0; i < publishers_.size(); ++i) {
      String message;
      message.data = std::string(get_name()) + "." + std::to_string(i) + " " + std::to_string(number_);
      publishers_[i]->publish(message);
    }
    std::size_t complete = 0;
    for (std::size_t i = 0; i < heard_.size(); ++i) {
      complete += heard_[i].count >= 3 * static_cast<int>(subscriptions_[i]->get_publisher_count()) &&
        heard_[i].count > 0;
    }
    std::size_t writers = 0;
    for (const auto & heard : heard_) {writers += heard.last.size();}
    if (complete == heard_.size() && told_ != writers) {
      RCLCPP_INFO(get_logger(), "heard %zu publishers on %zu topics", writers, heard_.size());
      told_ = writers;
    }
  }

  void hear(Heard & heard, const std::string & text)
  {
    const auto space = text.find(' ');
    int & last = heard.last[text.substr(0, space)];
    const int number = std::stoi(text.substr(space + 1));
    if (number <= last) {
      RCLCPP_ERROR(get_logger(), "%s after %d", text.c_str(), last);
    }
    last = number;
    ++heard.count;
  }

  rclcpp::TimerBase::SharedPtr timer_;
  std::vector<rclcpp::Publisher<String>::SharedPtr> publishers_;
  std::vector<rclcpp::Subscription<String>::SharedPtr> subscriptions_;
  std::vector<Heard> heard_;
  int number_ = 0;
  std::size_t told_ = 0;
};

int main(int argc, char ** argv)
{
  rclcpp::executors::SingleThreadedExecutor executor;
  std::vector<std::shared_ptr<Many>> nodes;
  std::chrono::milliseconds period = 100ms;
  for (const std::string & argument : rclcpp::init_and_remove_ros_arguments(argc, argv)) {
    const std::string value = argument.substr(std::min<std::size_t>(2, argument.size()));
    if (argument.rfind("e:", 0) == 0) {
      period = std::chrono::milliseconds(std::stoi(value));
    } else if (argument.rfind("n:", 0) == 0) {
      nodes.push_back(std::make_shared<Many>(value, period));
      executor.add_node(nodes.back());
    } else if (argument.rfind("p:", 0) == 0) {
      nodes.back()->publish_on(value);
    } else if (argument.rfind("s:", 0) == 0) {
      nodes.back()->subscribe_to(value);
    }
  }
  executor.spin();
  rclcpp::shutdown();
  return 0;
}
