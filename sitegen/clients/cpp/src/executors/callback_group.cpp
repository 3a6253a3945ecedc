#include "rclcpp/callback_group.hpp"

#include <algorithm>

#include "rclcpp/detail/stacks.hpp"

namespace rclcpp
{

std::size_t CallbackGroup::size() const
{
  std::size_t all = 0;
  for (const auto & kind : members_) {all += kind.size();}
  return all;
}

void CallbackGroup::give_back()
{
  can_be_taken_from_ = true;
  if (waited_for.exchange(false)) {detail::wake();}
}

void CallbackGroup::add(detail::ExecutableKind kind, std::weak_ptr<detail::Executable> executable)
{
  members_[static_cast<std::size_t>(kind)].push_back(std::move(executable));
}

void CallbackGroup::remove(
  detail::ExecutableKind kind, const std::shared_ptr<detail::Executable> & executable)
{
  auto & members = members_[static_cast<std::size_t>(kind)];
  const auto is_it = [&executable](const auto & member) {return member.lock() == executable;};
  members.erase(std::remove_if(members.begin(), members.end(), is_it), members.end());
}

std::vector<std::shared_ptr<detail::Executable>> CallbackGroup::living(detail::ExecutableKind kind)
{
  auto & members = members_[static_cast<std::size_t>(kind)];
  std::vector<std::shared_ptr<detail::Executable>> living;
  const auto gone = [&living](const std::weak_ptr<detail::Executable> & member) {
      auto locked = member.lock();
      if (locked) {living.push_back(std::move(locked));}
      return member.expired();
    };
  members.erase(std::remove_if(members.begin(), members.end(), gone), members.end());
  return living;
}

}  // namespace rclcpp
