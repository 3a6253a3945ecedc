// Groot2Publisher of BehaviorTree.CPP 4, whose own source needs the sockets of ZeroMQ. Programs refer
// to it even if they are not asked to publish, as the navigator of Nav2 does.
#include <chrono>
#include <iostream>

#include "behaviortree_cpp/loggers/groot2_publisher.h"

namespace BT
{

struct Groot2Publisher::PImpl
{
};

Groot2Publisher::Groot2Publisher(const Tree & tree, unsigned)
: StatusChangeLogger(tree.rootNode())
{
  std::cerr << "Groot2 cannot connect to a node in a page" << std::endl;
}

Groot2Publisher::~Groot2Publisher() = default;

void Groot2Publisher::setMaxHeartbeatDelay(std::chrono::milliseconds) {}

std::chrono::milliseconds Groot2Publisher::maxHeartbeatDelay() const {return {};}

void Groot2Publisher::callback(Duration, const TreeNode &, NodeStatus, NodeStatus) {}

void Groot2Publisher::flush() {}

}  // namespace BT
