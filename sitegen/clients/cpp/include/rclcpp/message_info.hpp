#pragma once

#include <cstdint>
#include <cstring>

using rmw_time_point_value_t = std::int64_t;

struct rmw_gid_t
{
  const char * implementation_identifier;
  std::uint8_t data[16];
};

struct rmw_message_info_t
{
  rmw_time_point_value_t source_timestamp;  // ns since 1970
  rmw_time_point_value_t received_timestamp;
  std::uint64_t publication_sequence_number;
  std::uint64_t reception_sequence_number;
  rmw_gid_t publisher_gid;
  bool from_intra_process;
};

namespace rclcpp
{

class MessageInfo
{
public:
  MessageInfo() = default;
  explicit MessageInfo(const rmw_message_info_t & info)
  : info_(info) {}

  const rmw_message_info_t & get_rmw_message_info() const {return info_;}
  rmw_message_info_t & get_rmw_message_info() {return info_;}

private:
  rmw_message_info_t info_{};
};

}  // namespace rclcpp
