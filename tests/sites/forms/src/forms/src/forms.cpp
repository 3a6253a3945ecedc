// Every usual form of the calls of rclcpp, in one program that talks to itself.
#include <chrono>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

using namespace std::chrono_literals;
using std::placeholders::_1;
using String = std_msgs::msg::String;

static std::set<std::string> heard;

static void free_function(const String & message) {heard.insert("free function " + message.data);}

class Forms : public rclcpp::Node
{
public:
  Forms()
  : Node("forms")
  {
    add("reference", [](const String &) {heard.insert("reference");});
    add("shared", [](String::SharedPtr m) {heard.insert("shared " + m->data);});
    add("const shared", [](String::ConstSharedPtr m) {heard.insert("const shared " + m->data);});
    add("shared reference", [](const String::SharedPtr & m) {heard.insert("reference " + m->data);});
    add("unique", [](String::UniquePtr m) {heard.insert("unique " + m->data);});
    add("info", [this](const String & message, const rclcpp::MessageInfo & info) {
        const auto & raw = info.get_rmw_message_info();
        const auto age = now().nanoseconds() - raw.source_timestamp;
        const bool sane = age >= 0 && age < 5000000000 && raw.publication_sequence_number == 1 &&
          raw.received_timestamp >= raw.source_timestamp;
        heard.insert("info " + message.data + (sane ? " sane" : " odd"));
      });
    add("unique info", [](String::UniquePtr m, const rclcpp::MessageInfo &) {
        heard.insert("unique info " + m->data);
      });
    add("bytes", [](std::shared_ptr<rclcpp::SerializedMessage> bytes) {
        heard.insert("bytes " + std::to_string(bytes->size()));
      });
    add("bind", std::bind(&Forms::member, this, _1));
    add("bind shared", std::bind(&Forms::shared_member, this, _1));
    add("free function", free_function);
    add("function", std::function<void(String::SharedPtr)>([](String::SharedPtr) {
        heard.insert("function");
      }));
    publisher_ = create_publisher<String>("~/words", rclcpp::QoS(rclcpp::KeepLast(5)).reliable());
    first_ = create_wall_timer(10ms, [this](rclcpp::TimerBase & timer) {
        timer.cancel();
        publish();
      });
    second_ = create_wall_timer(10ms, std::bind(&Forms::tick, this));
  }

  int ticks() const {return ticks_;}

private:
  template<class CallbackT>
  void add(const char *, CallbackT callback)
  {
    subscriptions_.push_back(create_subscription<String>("~/words", 10, callback));
  }

  void member(const String & message) const {heard.insert("bind " + message.data);}
  void shared_member(const String::SharedPtr message) {heard.insert("bind shared " + message->data);}

  void publish()
  {
    RCLCPP_INFO(
      get_logger(), "%s to %zu on %s as %s in %s", "publishing",
      publisher_->get_subscription_count(), publisher_->get_topic_name(),
      get_fully_qualified_name(), get_namespace());
    auto message = std::make_unique<String>();
    message->data = "hi";
    publisher_->publish(std::move(message));
  }

  void tick()
  {
    if (++ticks_ == 20) {rclcpp::shutdown();}
  }

  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
  rclcpp::Publisher<String>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr first_;
  rclcpp::TimerBase::SharedPtr second_;
  int ticks_ = 0;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::on_shutdown([]() {heard.insert("shutdown callback");});
  // So many that the clock steps within one, too: each must end.
  for (int i = 0; i < 5000; ++i) {rclcpp::sleep_for(20us);}
  auto forms = std::make_shared<Forms>();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(forms);
  executor.spin();

  const auto logger = rclcpp::get_logger("result").get_child("of");
  for (const auto & words : heard) {RCLCPP_INFO(logger, "%s", words.c_str());}
  RCLCPP_INFO(
    logger, "ticks %d, ok %d, duration %.3f, kept %zu, %s", forms->ticks(), rclcpp::ok(),
    (rclcpp::Time(5, 0) - rclcpp::Time(2, 500000000) + rclcpp::Duration(250ms)).seconds(),
    rclcpp::SensorDataQoS().depth(), rclcpp::Rate(10).sleep() ? "slept" : "down");

  builtin_interfaces::msg::Time stamp;
  stamp.sec = 4;
  stamp = stamp + rclcpp::Duration(2, 500) - rclcpp::Duration(1, 0);
  const builtin_interfaces::msg::Duration longest = rclcpp::Duration::max() * 2.5;
  rclcpp::Duration scaled(2, 0);
  scaled *= 0.125;
  RCLCPP_INFO(
    logger, "stamp %d.%09u, longest %d, scaled %.2f, %lld ns", stamp.sec, stamp.nanosec,
    longest.sec, scaled.seconds(), RCL_S_TO_NS(3));
  return 0;
}
