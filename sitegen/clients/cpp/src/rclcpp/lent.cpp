#include "rclcpp/detail/lent.hpp"

#include <deque>
#include <map>

namespace rclcpp
{
namespace detail
{

namespace
{

struct Entry
{
  std::uint64_t sequence;
  std::shared_ptr<Lent> message;
};

std::map<std::string, std::size_t> & topics()
{
  static std::map<std::string, std::size_t> all;
  return all;
}

/// By the endpoint that published them.
std::map<double, std::deque<Entry>> & entries()
{
  static std::map<double, std::deque<Entry>> all;
  return all;
}

}  // namespace

void borrow(const std::string & topic, bool begins)
{
  if (begins) {
    ++topics()[topic];
  } else if (--topics()[topic] == 0) {
    topics().erase(topic);
  }
}

std::size_t borrowers(const std::string & topic)
{
  const auto found = topics().find(topic);
  return found == topics().end() ? 0 : found->second;
}

void lend(
  double writer, std::uint64_t sequence, std::shared_ptr<Lent> message, std::size_t borrowers,
  std::size_t depth)
{
  message->left = borrowers;
  auto & own = entries()[writer];
  own.push_back({sequence, std::move(message)});
  // What a subscription lost it never takes.
  while (own.size() > depth) {own.pop_front();}
}

void forget_lent(double writer) {entries().erase(writer);}

std::shared_ptr<Lent> lent(double writer, std::uint64_t sequence)
{
  const auto own = entries().find(writer);
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

}  // namespace detail
}  // namespace rclcpp
