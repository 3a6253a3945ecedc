// Filters whose messages are put in by hand, but for one that goes by when they come.
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

#include "message_filters/delta_filter.hpp"
#include "message_filters/input_aligner.hpp"
#include "message_filters/pass_through.hpp"
#include "message_filters/sync_policies/latest_time.h"
#include "message_filters/synchronizer.h"
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/imu.hpp"
#include "sensor_msgs/msg/temperature.hpp"

using sensor_msgs::msg::Imu;
using sensor_msgs::msg::Temperature;
using namespace std::chrono_literals;

namespace
{

template<class M>
std::shared_ptr<const M> at(int seconds)
{
  auto made = std::make_shared<M>();
  made->header.stamp.sec = seconds;
  return made;
}

std::shared_ptr<const Temperature> degrees(double celsius)
{
  auto made = std::make_shared<Temperature>();
  made->temperature = celsius;
  return made;
}

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("aligning");

  message_filters::PassThrough<Temperature> source;
  message_filters::DeltaFilter<Temperature> delta(
    source, {[](const Temperature::ConstSharedPtr & message) {
        return message_filters::MFieldType(message->temperature);
      }});
  delta.registerCallback(
    [](const Temperature::ConstSharedPtr & message) {
      std::printf("delta %.0f\n", message->temperature);
    });
  for (double celsius : {20.0, 20.0, 21.0, 21.0, 20.0}) {source.add(degrees(celsius));}

  message_filters::InputAligner<Temperature, Imu> aligner(rclcpp::Duration(5, 0));
  aligner.registerCallback<0>(
    [](const Temperature & message) {std::printf("aligned a %d\n", message.header.stamp.sec);});
  aligner.registerCallback<1>(
    [](const Imu::ConstSharedPtr & message) {
      std::printf("aligned b %d\n", message->header.stamp.sec);
    });
  aligner.setInputPeriod<0>(rclcpp::Duration(1, 0));
  aligner.add<1>(at<Imu>(3));
  aligner.add<0>(at<Temperature>(2));
  aligner.add<0>(at<Temperature>(1));
  aligner.dispatchMessages();  // not 3, for the next of the other input may be as early
  aligner.add<1>(at<Imu>(4));
  aligner.add<0>(at<Temperature>(1));  // too late
  aligner.dispatchMessages();
  std::puts("a is silent");
  aligner.add<1>(at<Imu>(9));
  aligner.dispatchMessages();
  const auto status = aligner.getQueueStatus<0>();
  std::printf(
    "passed %zu, dropped %zu, waiting %zu\n", status.msgs_processed, status.msgs_dropped,
    status.queue_size);

  using Latest = message_filters::sync_policies::LatestTime<Temperature, Imu>;
  message_filters::Synchronizer<Latest> latest{Latest(node->get_clock())};
  latest.registerCallback(
    [](const Temperature::ConstSharedPtr & a, const Imu::ConstSharedPtr & b) {
      std::printf("latest %d %d\n", a->header.stamp.sec, b->header.stamp.sec);
    });
  latest.add<0>(at<Temperature>(1));
  latest.add<1>(at<Imu>(1));
  std::this_thread::sleep_for(40ms);
  latest.add<0>(at<Temperature>(2));
  std::this_thread::sleep_for(40ms);
  latest.add<0>(at<Temperature>(3));
  latest.add<1>(at<Imu>(2));  // comes half as often
  std::this_thread::sleep_for(1ms);
  latest.add<0>(at<Temperature>(4));
  rclcpp::shutdown();
  return 0;
}
