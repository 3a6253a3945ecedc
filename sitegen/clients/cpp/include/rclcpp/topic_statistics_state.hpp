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

/// Called with what is known of each message that arrives.
using Arrival = std::function<void (const rmw_message_info_t &)>;

/// Publish statistics about a subscription of `node` as long as what it returns lives.
Arrival make_topic_statistics(
  node_interfaces::NodeBaseInterface & node, const SubscriptionOptionsBase & options);

/// Whether statistics are wanted. What makes them is named only where somebody enables them, so that
/// no other program is linked with it.
class TopicStatisticsSetting
{
public:
  using Make = decltype(&make_topic_statistics);

  TopicStatisticsSetting(TopicStatisticsState state)  // NOLINT: as good as the state
  : state_(state), make_(state == TopicStatisticsState::Enable ? &make_topic_statistics : nullptr)
  {}
  operator TopicStatisticsState() const {return state_;}  // NOLINT: as good as the state
  /// Null if there are to be none; `above` is what counts where the node is to say.
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
