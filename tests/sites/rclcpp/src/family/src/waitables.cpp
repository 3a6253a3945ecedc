// Waitables of one's own, as Jazzy has them and as Humble does, in executors and in wait sets.
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp/waitable.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;

namespace
{

class Bell : public rclcpp::Waitable
{
public:
  size_t get_number_of_ready_guard_conditions() override {return 1;}
  void add_to_wait_set(rcl_wait_set_t & wait_set) override {button_.add_to_wait_set(wait_set);}
  bool is_ready(const rcl_wait_set_t & wait_set) override
  {
    for (size_t i = 0; i < wait_set.size_of_guard_conditions; ++i) {
      if (wait_set.guard_conditions[i] == &button_.get_rcl_guard_condition()) {return true;}
    }
    return false;
  }
  std::shared_ptr<void> take_data() override {return std::make_shared<int>(++rings_);}
  std::shared_ptr<void> take_data_by_entity_id(size_t) override {return take_data();}
  void execute(const std::shared_ptr<void> & data) override
  {
    std::printf("bell %d\n", *std::static_pointer_cast<int>(data));
  }
  void set_on_ready_callback(std::function<void(size_t, int)>) override {}
  void clear_on_ready_callback() override {}
  std::vector<std::shared_ptr<rclcpp::TimerBase>> get_timers() const override {return {};}
  void ring() {button_.trigger();}

private:
  rclcpp::GuardCondition button_;
  int rings_ = 0;
};

class OldBell : public rclcpp::Waitable
{
public:
  void add_to_wait_set(rcl_wait_set_t * wait_set) override {button_.add_to_wait_set(wait_set);}
  bool is_ready(rcl_wait_set_t * wait_set) override {return wait_set->guard_conditions[0];}
  std::shared_ptr<void> take_data() override {return nullptr;}
  void execute(std::shared_ptr<void> &) override {std::puts("old bell");}
  void ring() {button_.trigger();}

private:
  rclcpp::GuardCondition button_;
};

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("waitables");
  auto bell = std::make_shared<Bell>();
  auto old = std::make_shared<OldBell>();
  auto waitables = node->get_node_waitables_interface();
  auto group = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
  waitables->add_waitable(bell, group);
  waitables->add_waitable(old, nullptr);

  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  std::thread ringing([&] {
      std::this_thread::sleep_for(20ms);
      bell->ring();
    });
  executor.spin_once(5s);
  ringing.join();
  executor.spin_some();  // nothing
  old->ring();
  executor.spin_once(5s);
  waitables->remove_waitable(bell, group);
  bell->ring();
  executor.spin_some();
  std::puts("removed");

  rclcpp::WaitSet set;
  set.add_waitable(bell);
  for (int i = 0; i < 2; ++i) {
    auto result = set.wait(20ms);
    if (result.kind() == rclcpp::WaitResultKind::Timeout) {
      std::puts("timeout");
      continue;
    }
    while (auto waitable = result.next_ready_waitable()) {waitable->execute(waitable->take_data());}
  }

  // The events of a subscription are waited for with it.
  rclcpp::SubscriptionOptions options;
  options.event_callbacks.matched_callback = [](rclcpp::MatchedInfo & info) {
      std::printf("matched %zu\n", info.current_count);
    };
  auto words = node->create_subscription<std_msgs::msg::String>(
    "words", 10, [](std_msgs::msg::String::UniquePtr) {}, options);
  rclcpp::WaitSet events({{words}});
  auto publisher = node->create_publisher<std_msgs::msg::String>("words", 10);
  auto result = events.wait(5s);
  if (auto event = result.next_ready_waitable()) {event->execute(event->take_data());}
  // Nothing else here has to do with parameters.
  std::printf("has %s\n", node->list_parameters({}, 0).names.at(0).c_str());
  rclcpp::shutdown();
  return 0;
}
