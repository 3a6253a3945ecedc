#pragma once

#include <cstdint>
#include <ostream>
#include <string>

namespace rclcpp
{

/// A network address; endpoints in a page have none.
class NetworkFlowEndpoint
{
public:
  const std::string & transport_protocol() const {return none_;}
  const std::string & internet_protocol() const {return none_;}
  std::uint16_t transport_port() const {return 0;}
  std::uint32_t flow_label() const {return 0;}
  std::uint8_t dscp() const {return 0;}
  const std::string & internet_address() const {return none_;}

private:
  std::string none_;
};

inline bool operator==(const NetworkFlowEndpoint &, const NetworkFlowEndpoint &) {return true;}
inline bool operator!=(const NetworkFlowEndpoint &, const NetworkFlowEndpoint &) {return false;}
inline std::ostream & operator<<(std::ostream & os, const NetworkFlowEndpoint &)
{
  return os << "{}";
}

}  // namespace rclcpp
