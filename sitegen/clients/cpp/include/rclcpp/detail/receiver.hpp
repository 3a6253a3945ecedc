// An endpoint that receives messages: a subscription, a service or a client.
#pragma once

#include <cstdint>
#include <string>

#include "rclcpp/detail/executable.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/message_info.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rosidl_typesupport_sitegen_cpp/message_type_support.hpp"

namespace rclcpp
{
namespace detail
{

using MessageMembers = rosidl_typesupport_sitegen_cpp::MessageMembers;

/// An endpoint of the graph, which it leaves when destroyed.
class Endpoint
{
public:
  RCLCPP_DISABLE_COPY(Endpoint)

  /// `kind` is one of host.h; `name` is expanded and remapped as `node` says.
  Endpoint(
    std::int32_t kind, const node_interfaces::NodeBaseInterface & node, const std::string & name,
    const std::string & type, const QoS & qos);
  virtual ~Endpoint();

  const std::string & name() const {return name_;}
  const QoS & qos() const {return qos_;}
  std::int32_t id() const {return id_;}
  /// As those see it that get its messages.
  rmw_gid_t gid() const;
  /// How many endpoints at the other side match this one now.
  std::size_t matched() const;

private:
  std::string name_;
  QoS qos_;
  std::int32_t id_;
};

/// An endpoint at which messages wait until an executor comes for them.
class Receiver : public Endpoint, public Executable
{
public:
  using Endpoint::Endpoint;

  /// Handle the oldest message that waits; false if none did.
  bool execute_one() override;
  /// Whether a message waits.
  bool is_ready() const;
  /// Remove the oldest message and return it in `bytes`, with what is known of it and the endpoint
  /// that sent it; false if none waits.
  bool take_bytes(SerializedMessage & bytes, rmw_message_info_t & info, double & writer_gid);

protected:
  /// Handle a message; `writer_gid` identifies its sender.
  virtual void handle(
    const SerializedMessage & bytes, rmw_message_info_t & info, double writer_gid) = 0;

  /// Read `bytes` into `message`; when they are of another type, log an error and return false.
  bool decode(
    const MessageMembers & type, const SerializedMessage & bytes, void * message) const;

private:
  std::uint64_t received_ = 0;
};

/// The bytes of `message`, in a buffer that lives until the next call.
struct Bytes
{
  const std::uint8_t * data;
  std::uint32_t size;
};
Bytes encode(const MessageMembers & type, const void * message);

/// The name of the service of which `request` is the request: std_srvs/srv/Trigger.
std::string service_type(const MessageMembers & request);

}  // namespace detail
}  // namespace rclcpp
