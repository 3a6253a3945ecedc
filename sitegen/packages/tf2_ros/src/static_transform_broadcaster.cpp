#include "tf2_ros/static_transform_broadcaster.hpp"

#include <algorithm>

namespace tf2_ros
{

void StaticTransformBroadcaster::sendTransform(
  const geometry_msgs::msg::TransformStamped & transform)
{
  sendTransform(std::vector<geometry_msgs::msg::TransformStamped>{transform});
}

void StaticTransformBroadcaster::sendTransform(
  const std::vector<geometry_msgs::msg::TransformStamped> & transforms)
{
  // Late subscribers receive only the last message, so each message contains all transforms.
  auto & all = net_message_.transforms;
  for (const auto & transform : transforms) {
    const auto known = std::find_if(
      all.begin(), all.end(), [&](const auto & each) {
        return each.child_frame_id == transform.child_frame_id;
      });
    if (known == all.end()) {
      all.push_back(transform);
    } else {
      *known = transform;
    }
  }
  publisher_->publish(net_message_);
}

}  // namespace tf2_ros
