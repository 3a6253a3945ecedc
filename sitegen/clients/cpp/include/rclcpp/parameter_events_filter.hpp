#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{

/// The changes of some parameters in an event.
class ParameterEventsFilter
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(ParameterEventsFilter)

  enum class EventType {NEW, DELETED, CHANGED};
  using EventPair = std::pair<EventType, const rcl_interfaces::msg::Parameter *>;

  ParameterEventsFilter(
    std::shared_ptr<const rcl_interfaces::msg::ParameterEvent> event,
    const std::vector<std::string> & names, const std::vector<EventType> & types)
  : event_(std::move(event))
  {
    const auto take = [&](EventType type, const auto & parameters) {
        if (std::find(types.begin(), types.end(), type) == types.end()) {return;}
        for (const auto & parameter : parameters) {
          if (std::find(names.begin(), names.end(), parameter.name) != names.end()) {
            result_.emplace_back(type, &parameter);
          }
        }
      };
    take(EventType::NEW, event_->new_parameters);
    take(EventType::CHANGED, event_->changed_parameters);
    take(EventType::DELETED, event_->deleted_parameters);
  }

  const std::vector<EventPair> & get_events() const {return result_;}

private:
  std::shared_ptr<const rcl_interfaces::msg::ParameterEvent> event_;
  std::vector<EventPair> result_;
};

}  // namespace rclcpp
