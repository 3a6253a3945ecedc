#pragma once

#include <functional>
#include <memory>

#include "rmw/types.h"

namespace rclcpp
{

struct SubscriptionOptionsBase;

namespace node_interfaces
{
class NodeBaseInterface;
}  // namespace node_interfaces

enum class TopicStatisticsState {Enable, Disable, NodeDefault};

namespace detail
{

/// Called with the metadata of each message received.
using Arrival = std::function<void (const rmw_message_info_t &)>;

/// Publish statistics about a subscription of `node` during the lifetime of the result.
Arrival make_topic_statistics(
  node_interfaces::NodeBaseInterface & node, const SubscriptionOptionsBase & options);

/// Whether statistics are enabled. The implementation is referenced only where they are enabled, so that
/// other programs do not link it.
class TopicStatisticsSetting
{
public:
  using Make = decltype(&make_topic_statistics);

  TopicStatisticsSetting(TopicStatisticsState state)  // NOLINT: as good as the state
  : state_(state), make_(state == TopicStatisticsState::Enable ? &make_topic_statistics : nullptr)
  {}
  operator TopicStatisticsState() const {return state_;}  // NOLINT: as good as the state
  /// Null if they are disabled; `above` is the setting of the node, for options that leave it to
  /// the node.
  Make maker(const TopicStatisticsSetting & above) const
  {
    return state_ == TopicStatisticsState::NodeDefault ? above.make_ : make_;
  }

private:
  TopicStatisticsState state_;
  Make make_;
};

}  // namespace detail
}  // namespace rclcpp
