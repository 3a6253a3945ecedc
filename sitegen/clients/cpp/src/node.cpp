#include "rclcpp/node.hpp"

#include "rclcpp/detail/arguments.hpp"
#include "rclcpp/detail/node_parameters.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp
{

namespace
{

/// What counts for a node: its own arguments first, then those of the program.
detail::Arguments arguments_of(const NodeOptions & options)
{
  std::vector<const char *> words;
  for (const auto & word : options.arguments()) {words.push_back(word.c_str());}
  auto own = detail::parse_arguments(static_cast<int>(words.size()), words.data());
  if (options.use_global_arguments()) {own.append(options.context()->arguments());}
  return own;
}

}  // namespace

Node::Node(const std::string & name, const NodeOptions & options)
: Node(name, "", options)
{
}

Node::Node(
  const std::string & name, const std::string & name_space, const NodeOptions & options)
: options_(options),
  base_(
    std::make_shared<node_interfaces::NodeBaseInterface>(
      name, name_space, options.context(), arguments_of(options))),
  logger_(detail::logger_name(base_->get_fully_qualified_name())),
  rosout_(*base_, logger_.get_name()),
  clock_(std::make_shared<Clock>(options.clock_type()))
{
  if (detail::make_node_parameters) {
    parameters_ = detail::make_node_parameters(base_, options, clock_, time_source_);
  } else if (!base_->arguments().parameters.empty()) {
    RCLCPP_WARN(
      logger_, "parameter '%s' has no effect: this program does not use parameters",
      base_->arguments().parameters[0].name.c_str());
  }
}

}  // namespace rclcpp
