#pragma once

#include <cstddef>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"

namespace rclcpp
{

/// Declare the parameters of `source` that `destination` lacks. With `override_existing_params`,
/// also set those that it has. Both are pointers to nodes.
template<class SourceT, class DestinationT>
void copy_all_parameter_values(
  const SourceT & source, const DestinationT & destination,
  const bool override_existing_params = false)
{
  const auto from = source->get_node_parameters_interface();
  const auto to = destination->get_node_parameters_interface();
  const auto warn = [&](const std::string & name, const char * reason) {
      RCLCPP_WARN(
        destination->get_node_logging_interface()->get_logger(),
        "Unable to set parameter (%s): %s!", name.c_str(), reason);
    };
  const auto names = from->list_parameters({}, 0).names;
  const auto parameters = from->get_parameters(names);
  const auto descriptors = from->describe_parameters(names);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto & name = parameters[i].get_name();
    if (!to->has_parameter(name)) {
      to->declare_parameter(name, parameters[i].get_parameter_value(), descriptors[i]);
    } else if (override_existing_params) {
      try {
        const auto result = to->set_parameters_atomically({parameters[i]});
        if (!result.successful) {warn(name, result.reason.c_str());}
      } catch (const exceptions::InvalidParameterTypeException & error) {
        warn(name, error.what());
      }
    }
  }
}

}  // namespace rclcpp
