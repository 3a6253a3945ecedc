// tf2_monitor [SOURCE_FRAME TARGET_FRAME]: print the delay and the rate of transforms.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/buffer.hpp"
#include "tf2_ros/qos.hpp"

namespace
{

// Messages do not identify the node that sent them.
constexpr char kAuthority[] = "<no authority available>";
constexpr std::size_t kKept = 1000;

/// A window of the newest values.
struct Series
{
  void add(double number)
  {
    numbers.push_back(number);
    if (numbers.size() > kKept) {numbers.pop_front();}
  }
  double average() const
  {
    return numbers.empty() ? 0 : std::accumulate(numbers.begin(), numbers.end(), 0.0) /
           static_cast<double>(numbers.size());
  }
  double largest() const
  {
    return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
  }

  std::deque<double> numbers;
};

class Monitor
{
public:
  Monitor(rclcpp::Node::SharedPtr node, std::string source, std::string target)
  : node_(std::move(node)), source_(std::move(source)), target_(std::move(target)),
    buffer_(node_->get_clock())
  {
    const auto note = [this](const tf2_msgs::msg::TFMessage & message) {take(message, false);};
    const auto note_static = [this](const tf2_msgs::msg::TFMessage & message) {take(message, true);};
    moving_ = node_->create_subscription<tf2_msgs::msg::TFMessage>(
      "/tf", tf2_ros::DynamicListenerQoS(), note);
    fixed_ = node_->create_subscription<tf2_msgs::msg::TFMessage>(
      "/tf_static", tf2_ros::StaticListenerQoS(), note_static);
  }

  bool is_about_chain() const {return !source_.empty();}
  bool has_chain() const {return buffer_.canTransform(source_, target_, tf2::TimePointZero);}

  void sample()
  {
    if (!is_about_chain()) {return;}
    try {
      const auto found = buffer_.lookupTransform(source_, target_, tf2::TimePointZero);
      chain_.add((node_->now() - found.header.stamp).seconds());
    } catch (const tf2::TransformException & error) {
      std::printf("Exception thrown:%s\n", error.what());
    }
  }

  void print() const
  {
    std::vector<std::string> frames;
    if (is_about_chain()) {
      frames = chain();
      std::printf("\n\nRESULTS: for %s to %s\nChain is: ", source_.c_str(), target_.c_str());
      for (std::size_t i = 0; i < frames.size(); ++i) {
        std::printf("%s%s", i ? " -> " : "", frames[i].c_str());
      }
      std::printf("\nNet delay     avg = %g: max = %g\n", chain_.average(), chain_.largest());
    } else {
      for (const auto & one : delays_) {frames.push_back(one.first);}
      std::printf("\n\nRESULTS: for all Frames\n");
    }
    std::printf("\nFrames:\n");
    for (const auto & frame : frames) {
      const auto found = delays_.find(frame);
      if (found == delays_.end()) {continue;}
      std::printf(
        "Frame: %s, published by %s, Average Delay: %g, Max Delay: %g\n", frame.c_str(), kAuthority,
        found->second.average(), found->second.largest());
    }
    std::printf("\nAll Broadcasters:\n");
    if (!times_.numbers.empty()) {
      const double span = times_.numbers.back() - times_.numbers.front();
      const double rate = span > 0 ? static_cast<double>(times_.numbers.size()) / span : 0;
      std::printf(
        "Node: %s %g Hz, Average Delay: %g Max Delay: %g\n", kAuthority, rate, all_.average(),
        all_.largest());
    }
    std::fflush(stdout);
  }

private:
  void take(const tf2_msgs::msg::TFMessage & message, bool is_static)
  {
    const double now = node_->now().seconds();
    double sum = 0;
    for (const auto & one : message.transforms) {
      buffer_.setTransform(one, kAuthority, is_static);
      const double delay = is_static ? 0 : now - rclcpp::Time(one.header.stamp).seconds();
      delays_[one.child_frame_id].add(delay);
      parents_[one.child_frame_id] = one.header.frame_id;
      sum += delay;
    }
    if (message.transforms.empty()) {return;}
    all_.add(sum / static_cast<double>(message.transforms.size()));
    times_.add(now);
  }

  /// A frame and its ancestors.
  std::vector<std::string> above(std::string frame) const
  {
    std::vector<std::string> frames{frame};
    for (auto up = parents_.find(frame); up != parents_.end() && frames.size() < kKept; ) {
      frames.push_back(up->second);
      up = parents_.find(up->second);
    }
    return frames;
  }

  /// From the source up to the common ancestor, and down to the target.
  std::vector<std::string> chain() const
  {
    auto up = above(source_);
    auto down = above(target_);
    while (up.size() > 1 && down.size() > 1 && *(up.end() - 2) == *(down.end() - 2)) {
      up.pop_back();
      down.pop_back();
    }
    if (!up.empty() && !down.empty() && up.back() == down.back()) {down.pop_back();}
    up.insert(up.end(), down.rbegin(), down.rend());
    return up;
  }

  rclcpp::Node::SharedPtr node_;
  std::string source_;
  std::string target_;
  tf2_ros::Buffer buffer_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr moving_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr fixed_;
  std::map<std::string, Series> delays_;        // by the child
  std::map<std::string, std::string> parents_;  // by the child
  Series chain_;
  Series all_;
  Series times_;
};

}  // namespace

int main(int argc, char ** argv)
{
  const auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  if (arguments.size() != 1 && arguments.size() != 3) {
    std::printf("TF_Monitor: usage: tf2_monitor framea frameb\n");
    return 1;
  }
  auto node = rclcpp::Node::make_shared("tf2_monitor");
  const bool chain = arguments.size() == 3;
  Monitor monitor(node, chain ? arguments[1] : "", chain ? arguments[2] : "");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (rclcpp::ok() && chain && !monitor.has_chain()) {
    RCLCPP_INFO(
      node->get_logger(), "Waiting for transform chain to become available between %s and %s ",
      arguments[1].c_str(), arguments[2].c_str());
    for (int i = 0; i < 10 && rclcpp::ok(); ++i) {
      executor.spin_once(std::chrono::milliseconds(100));
    }
  }
  rclcpp::Rate rate(10);
  for (int count = 1; rclcpp::ok(); ++count) {
    executor.spin_some();
    monitor.sample();
    if (count % 20 == 0) {monitor.print();}
    rate.sleep();
  }
  return 0;
}
