// Messages are put into filters by hand, so that nothing depends on when they arrive.
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "message_filters/cache.h"
#include "message_filters/chain.h"
#include "message_filters/pass_through.h"
#include "message_filters/subscriber.h"
#include "message_filters/sync_policies/approximate_epsilon_time.h"
#include "message_filters/sync_policies/approximate_time.h"
#include "message_filters/sync_policies/exact_time.h"
#include "message_filters/synchronizer.h"
#include "message_filters/time_synchronizer.h"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/temperature.hpp"

using sensor_msgs::msg::Imu;
using sensor_msgs::msg::Temperature;
using std::placeholders::_1;
using std::placeholders::_2;

namespace
{

template<class M>
std::shared_ptr<M> message(int milliseconds)
{
  auto made = std::make_shared<M>();
  made->header.stamp.sec = milliseconds / 1000;
  made->header.stamp.nanosec = milliseconds % 1000 * 1000000;
  return made;
}

template<class M>
int when(const M & message)
{
  return message.header.stamp.sec * 1000 + message.header.stamp.nanosec / 1000000;
}

class Listener
{
public:
  explicit Listener(std::string name)
  : name_(std::move(name)) {}

  void both(const Temperature::ConstSharedPtr & a, const Imu::ConstSharedPtr & b) const
  {
    std::printf("%s %d %d\n", name_.c_str(), when(*a), when(*b));
  }

private:
  std::string name_;
};

void by_reference(const Temperature & a, const Imu & b)
{
  std::printf("by reference %d %d\n", when(a), when(b));
}

/// Play the same two topics into any synchronizer.
template<class SyncT>
void play(SyncT & sync)
{
  for (int i = 0; i < 6; ++i) {
    sync.template add<0>(std::shared_ptr<const Temperature>(message<Temperature>(1000 + 100 * i)));
    if (i != 2) {
      sync.template add<1>(std::shared_ptr<const Imu>(message<Imu>(1000 + 100 * i + (i % 2) * 20)));
    }
  }
}

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  Listener exact("exact"), near("approximate"), close("epsilon");
  message_filters::TimeSynchronizer<Temperature, Imu> first(10);
  first.registerCallback(std::bind(&Listener::both, &exact, _1, _2));
  first.registerCallback(&by_reference);
  first.registerDropCallback(
    [](const Temperature::ConstSharedPtr & a, const Imu::ConstSharedPtr & b) {
      std::printf("dropped %s %s\n", a ? std::to_string(when(*a)).c_str() : "none",
      b ? std::to_string(when(*b)).c_str() : "none");
    });
  play(first);

  using Near = message_filters::sync_policies::ApproximateTime<Temperature, Imu>;
  message_filters::Synchronizer<Near> second(Near(10));
  second.registerCallback(&Listener::both, &near);
  play(second);
  Near strict(10);
  strict.setMaxIntervalDuration(rclcpp::Duration::from_seconds(0.01));
  message_filters::Synchronizer<Near> third(strict);
  third.registerCallback(
    [](const Temperature::ConstSharedPtr & a, const Imu::ConstSharedPtr & b) {
      std::printf("strict %d %d\n", when(*a), when(*b));
    });
  play(third);
  using Close = message_filters::sync_policies::ApproximateEpsilonTime<Temperature, Imu>;
  message_filters::Synchronizer<Close> fourth(Close(10, rclcpp::Duration::from_seconds(0.05)));
  fourth.registerCallback(&Listener::both, &close);
  play(fourth);

  // The size of the queue is enough for a policy, with or without the filters.
  auto sized = std::make_shared<message_filters::Synchronizer<Near>>(10);
  message_filters::PassThrough<Temperature> warm;
  message_filters::PassThrough<Imu> turned;
  sized->connectInput(warm, turned);
  message_filters::Synchronizer<Near> connected(10, warm, turned);
  message_filters::TimeSynchronizer<Temperature, Imu> timed(10, warm, turned);
  int pairs = 0;
  const auto count_pair = [&](const Temperature & a, const Imu &) {pairs += when(a);};
  sized->registerCallback(count_pair);
  connected.registerCallback(count_pair);
  timed.registerCallback(count_pair);
  warm.add(message<Temperature>(5));
  turned.add(message<Imu>(5));
  std::printf("pairs %d\n", pairs);

  message_filters::PassThrough<Imu> start;
  message_filters::Cache<Imu> cache(start, 3);
  for (int i : {1, 2, 4, 3}) {start.add(message<Imu>(i * 1000));}
  const auto seconds = [](int n) {return rclcpp::Time(n, 0, RCL_ROS_TIME);};
  std::printf("cache from %.0f to %.0f\n", cache.getOldestTime().seconds(), cache.getLatestTime().seconds());
  std::printf("between: %zu\n", cache.getInterval(seconds(3), seconds(4)).size());
  std::printf("before 3: %d\n", when(*cache.getElemBeforeTime(seconds(3))));
  std::printf("after 4: %s\n", cache.getElemAfterTime(seconds(4)) ? "one" : "none");
  message_filters::Chain<Imu> chain(start);
  chain.addFilter(std::make_shared<message_filters::PassThrough<Imu>>());
  chain.addFilter(std::make_shared<message_filters::Cache<Imu>>(2));
  const message_filters::ChainBase & base = chain;
  std::printf("second filter: %s\n", base.getFilter<message_filters::Cache<Imu>>(1) ? "one" : "none");
  std::printf("third filter: %s\n", base.getFilter<message_filters::Cache<Imu>>(2) ? "one" : "none");
  chain.registerCallback([](const Imu & imu) {std::printf("chain %d\n", when(imu));});
  start.add(message<Imu>(7000));

  // And over topics, as they are mostly used.
  auto node = rclcpp::Node::make_shared("matching");
  message_filters::Subscriber<Temperature> temperatures(node, "temperature", 10);
  message_filters::Subscriber<Imu> imus;
  imus.subscribe(node.get(), "imu", rmw_qos_profile_default);
  message_filters::TimeSynchronizer<Temperature, Imu> sync(temperatures, imus, 10);
  int matches = 0;
  sync.registerCallback(
    [&](const Temperature::ConstSharedPtr & a, const Imu::ConstSharedPtr &) {
      std::printf("%s %d\n", temperatures.getTopic().c_str(), when(*a));
      if (++matches == 2) {rclcpp::shutdown();}
    });
  auto hot = node->create_publisher<Temperature>("temperature", 10);
  auto turn = node->create_publisher<Imu>("imu", 10);
  int count = 0;
  auto timer = node->create_wall_timer(
    std::chrono::milliseconds(20), [&]() {
      ++count;
      hot->publish(*message<Temperature>(count));
      turn->publish(*message<Imu>(count));
    });
  rclcpp::spin(node);
  return 0;
}
