// The QoS of an endpoint: system defaults, and the form that the page uses.
#pragma once

#include <cstdint>

#include "rclcpp/detail/host.h"
#include "rclcpp/qos.hpp"

namespace rclcpp
{
namespace detail
{

/// Replace system defaults with those of Fast DDS: strict for what is offered, lenient for requests.
QoS settled(std::int32_t kind, QoS qos);

/// Convert QoS without system defaults to the page's form.
ros_qos host_qos(const QoS & qos);

}  // namespace detail
}  // namespace rclcpp
