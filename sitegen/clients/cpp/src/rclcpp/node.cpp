#include "rclcpp/node.hpp"

#include "rclcpp/detail/arguments.hpp"
#include "rclcpp/detail/node_parameters.hpp"
#include "rclcpp/logging.hpp"

namespace rclcpp
{

namespace
{

/// The arguments that apply to a node: its own first, then those of the program.
detail::Arguments arguments_of(const NodeOptions & options)
{
  std::vector<const char *> words;
  for (const auto & word : options.arguments()) {words.push_back(word.c_str());}
  auto own = detail::parse_arguments(static_cast<int>(words.size()), words.data());
  if (options.use_global_arguments()) {own.append(options.context()->arguments());}
  return own;
}

}  // namespace

namespace detail
{

AnyNode::AnyNode(
  const std::string & name, const std::string & name_space, const NodeOptions & options)
: SeesGraph(
    std::make_shared<node_interfaces::NodeBaseInterface>(
      name, name_space, options.context(), arguments_of(options))),
  options_(options),
  logger_(detail::logger_name(base_->get_fully_qualified_name())),
  rosout_(
    options.enable_rosout() ?
    std::make_shared<detail::Rosout>(*base_, logger_.get_name()) : nullptr),
  clock_(std::make_shared<Clock>(options.clock_type()))
{
  if (options.logger_services()) {logger_services_ = options.logger_services()(*base_);}
  if (detail::make_node_parameters) {
    parameters_ = detail::make_node_parameters(base_, options, clock_, time_source_);
  } else if (!base_->arguments().parameters.empty()) {
    RCLCPP_WARN(
      logger_, "parameter '%s' has no effect: this program does not use parameters",
      base_->arguments().parameters[0].name.c_str());
  }
}

AnyNode::AnyNode(const AnyNode & other, const std::string & sub_namespace)
: SeesGraph(other), HasParameters(other),
  options_(other.options_), sub_namespace_(other.extend_name(sub_namespace)),
  logger_(other.logger_), rosout_(other.rosout_), clock_(other.clock_),
  time_source_(other.time_source_), logger_services_(other.logger_services_)
{
}

std::string AnyNode::get_effective_namespace() const
{
  const std::string space = get_namespace();
  if (sub_namespace_.empty()) {return space;}
  return (space == "/" ? space : space + "/") + sub_namespace_;
}

std::string AnyNode::extend_name(const std::string & name) const
{
  const bool relative = !name.empty() && name[0] != '/' && name[0] != '~';
  return relative && !sub_namespace_.empty() ? sub_namespace_ + "/" + name : name;
}

}  // namespace detail

Node::SharedPtr Node::create_sub_node(const std::string & sub_namespace)
{
  if (sub_namespace.empty() || sub_namespace[0] == '/' || sub_namespace[0] == '~') {
    throw exceptions::NameValidationError(
            "sub_namespace", sub_namespace.c_str(),
            "a sub-namespace should not have a leading /", 0);
  }
  return SharedPtr(new Node(*this, sub_namespace));
}

}  // namespace rclcpp
