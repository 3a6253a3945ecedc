// The quality of service of an endpoint: what is left to the system, and what the page takes for it.
#pragma once

#include <cstdint>

#include "rclcpp/detail/host.h"
#include "rclcpp/qos.hpp"

namespace rclcpp
{
namespace detail
{

/// `qos` with what Fast DDS has where it is left to the system: it offers much and asks for little.
QoS settled(std::int32_t kind, QoS qos);

/// What the page takes for settled `qos`.
ros_qos host_qos(const QoS & qos);

}  // namespace detail
}  // namespace rclcpp
