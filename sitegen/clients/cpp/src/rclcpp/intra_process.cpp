#include "rclcpp/detail/intra_process.hpp"

#include <deque>
#include <map>

namespace rclcpp
{
namespace detail
{
namespace intra_process
{

namespace
{

struct Entry
{
  std::uint64_t sequence;
  std::shared_ptr<Message> message;
};

std::map<std::string, std::size_t> & topics()
{
  static std::map<std::string, std::size_t> all;
  return all;
}

/// Messages by the gid of their publisher.
std::map<double, std::deque<Entry>> & entries()
{
  static std::map<double, std::deque<Entry>> all;
  return all;
}

}  // namespace

void subscribe(const std::string & topic, bool adds)
{
  if (adds) {
    ++topics()[topic];
  } else if (--topics()[topic] == 0) {
    topics().erase(topic);
  }
}

std::size_t subscriptions(const std::string & topic)
{
  const auto found = topics().find(topic);
  return found == topics().end() ? 0 : found->second;
}

void put(
  double gid, std::uint64_t sequence, std::shared_ptr<Message> message, std::size_t subscriptions,
  std::size_t depth)
{
  message->left = subscriptions;
  auto & own = entries()[gid];
  own.push_back({sequence, std::move(message)});
  // Subscriptions that lost a message never take it.
  while (own.size() > depth) {own.pop_front();}
}

void forget(double gid) {entries().erase(gid);}

std::shared_ptr<Message> take(double gid, std::uint64_t sequence)
{
  const auto own = entries().find(gid);
  if (own == entries().end()) {return nullptr;}
  auto & all = own->second;
  for (auto one = all.begin(); one != all.end(); ++one) {
    if (one->sequence != sequence) {continue;}
    auto message = one->message;
    if (--message->left == 0) {all.erase(one);}
    return message;
  }
  return nullptr;
}

}  // namespace intra_process
}  // namespace detail
}  // namespace rclcpp
