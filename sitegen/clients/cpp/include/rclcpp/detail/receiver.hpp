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

  /// `kind` is one of host.h; `name` is expanded and remapped for `node`.
  Endpoint(
    std::int32_t kind, const node_interfaces::NodeBaseInterface & node, const std::string & name,
    const std::string & type, const QoS & qos);
  virtual ~Endpoint();

  const std::string & name() const {return name_;}
  const QoS & qos() const {return qos_;}
  std::int32_t id() const {return id_;}
  /// Its gid, as received with its messages.
  rmw_gid_t gid() const;
  /// Whether the endpoint with this gid is of this process.
  bool is_local(double gid) const;
  /// The number of matching endpoints.
  std::size_t matched() const;

private:
  std::string name_;
  QoS qos_;
  std::int32_t id_;
};

/// An endpoint whose messages wait until an executor takes them.
class Receiver : public Endpoint, public Executable
{
public:
  using Endpoint::Endpoint;

  /// Handle the oldest message; false if there is none.
  bool execute_one() override;
  /// Whether a message waits.
  bool is_ready() const;
  /// Remove the oldest message and return it in `bytes`, with its metadata and the endpoint that
  /// sent it; false if there is none.
  bool take_bytes(SerializedMessage & bytes, rmw_message_info_t & info, double & writer_gid);

protected:
  /// Remove the oldest request or response and read it into `message`; false if there is none.
  bool take_message(
    const MessageMembers & type, void * message, rmw_request_id_t & request_id);

  /// Handle a message; `writer_gid` identifies its sender.
  virtual void handle(
    const SerializedMessage & bytes, rmw_message_info_t & info, double writer_gid) = 0;

  /// Read `bytes` into `message`; if they are not of its type, log an error and return false.
  bool decode(
    const MessageMembers & type, const SerializedMessage & bytes, void * message) const;

  /// Drop what publishers in this process send, which is one context.
  bool ignores_local_ = false;

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

/// The service type of the request type `request`: std_srvs/srv/Trigger.
std::string service_type(const MessageMembers & request);

}  // namespace detail
}  // namespace rclcpp
