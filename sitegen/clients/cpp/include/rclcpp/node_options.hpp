#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp/topic_statistics_state.hpp"

namespace rclcpp
{

namespace detail
{
/// Provide the services for logger levels during the lifetime of the result.
std::shared_ptr<void> make_logger_services(node_interfaces::NodeBaseInterface & node);
}  // namespace detail

class NodeOptions
{
public:
  NodeOptions() = default;

  Context::SharedPtr context() const {return context_;}
  NodeOptions & context(Context::SharedPtr context)
  {
    context_ = std::move(context);
    return *this;
  }
  /// Arguments of this node alone, with their `--ros-args`; they come before those of the program.
  const std::vector<std::string> & arguments() const {return arguments_;}
  NodeOptions & arguments(const std::vector<std::string> & arguments)
  {
    arguments_ = arguments;
    return *this;
  }
  bool use_global_arguments() const {return use_global_arguments_;}
  NodeOptions & use_global_arguments(bool use)
  {
    use_global_arguments_ = use;
    return *this;
  }
  const std::vector<Parameter> & parameter_overrides() const {return parameter_overrides_;}
  std::vector<Parameter> & parameter_overrides() {return parameter_overrides_;}
  NodeOptions & parameter_overrides(const std::vector<Parameter> & parameter_overrides)
  {
    parameter_overrides_ = parameter_overrides;
    return *this;
  }
  template<class T>
  NodeOptions & append_parameter_override(const std::string & name, const T & value)
  {
    parameter_overrides_.emplace_back(name, ParameterValue(value));
    return *this;
  }
  bool enable_rosout() const {return enable_rosout_;}
  NodeOptions & enable_rosout(bool enable_rosout)
  {
    enable_rosout_ = enable_rosout;
    return *this;
  }
  /// Whether nodes of a program pass messages published as std::unique_ptr without copying them.
  bool use_intra_process_comms() const {return use_intra_process_comms_;}
  NodeOptions & use_intra_process_comms(bool use_intra_process_comms)
  {
    use_intra_process_comms_ = use_intra_process_comms;
    return *this;
  }
  bool enable_topic_statistics() const
  {
    return topic_statistics_ == TopicStatisticsState::Enable;
  }
  const detail::TopicStatisticsSetting & topic_statistics() const {return topic_statistics_;}
  NodeOptions & enable_topic_statistics(bool enable_topic_statistics)
  {
    topic_statistics_ =
      enable_topic_statistics ? TopicStatisticsState::Enable : TopicStatisticsState::Disable;
    return *this;
  }
  bool start_parameter_services() const {return start_parameter_services_;}
  NodeOptions & start_parameter_services(bool start_parameter_services)
  {
    start_parameter_services_ = start_parameter_services;
    return *this;
  }
  bool start_parameter_event_publisher() const {return start_parameter_event_publisher_;}
  NodeOptions & start_parameter_event_publisher(bool start_parameter_event_publisher)
  {
    start_parameter_event_publisher_ = start_parameter_event_publisher;
    return *this;
  }
  bool use_clock_thread() const {return use_clock_thread_;}
  NodeOptions & use_clock_thread(bool use_clock_thread)
  {
    use_clock_thread_ = use_clock_thread;
    return *this;
  }
  bool allow_undeclared_parameters() const {return allow_undeclared_parameters_;}
  NodeOptions & allow_undeclared_parameters(bool allow_undeclared_parameters)
  {
    allow_undeclared_parameters_ = allow_undeclared_parameters;
    return *this;
  }
  bool automatically_declare_parameters_from_overrides() const {return automatically_declare_parameters_from_overrides_;}
  NodeOptions & automatically_declare_parameters_from_overrides(bool automatically_declare_parameters_from_overrides)
  {
    automatically_declare_parameters_from_overrides_ = automatically_declare_parameters_from_overrides;
    return *this;
  }
  bool enable_logger_service() const {return logger_services_ != nullptr;}
  /// Referenced, and so linked, only by programs that enable the services for logger levels.
  NodeOptions & enable_logger_service(bool enable_logger_service)
  {
    logger_services_ = enable_logger_service ? &detail::make_logger_services : nullptr;
    return *this;
  }
  decltype(&detail::make_logger_services) logger_services() const {return logger_services_;}
  const QoS & clock_qos() const {return clock_qos_;}
  NodeOptions & clock_qos(const QoS & clock_qos)
  {
    clock_qos_ = clock_qos;
    return *this;
  }
  const QoS & parameter_event_qos() const {return parameter_event_qos_;}
  NodeOptions & parameter_event_qos(const QoS & parameter_event_qos)
  {
    parameter_event_qos_ = parameter_event_qos;
    return *this;
  }
  const QoS & rosout_qos() const {return rosout_qos_;}
  NodeOptions & rosout_qos(const QoS & rosout_qos)
  {
    rosout_qos_ = rosout_qos;
    return *this;
  }
  rcl_clock_type_t clock_type() const {return clock_type_;}
  NodeOptions & clock_type(const rcl_clock_type_t & clock_type)
  {
    clock_type_ = clock_type;
    return *this;
  }

private:
  Context::SharedPtr context_ = contexts::get_global_default_context();
  std::vector<std::string> arguments_;
  bool use_global_arguments_ = true;
  std::vector<Parameter> parameter_overrides_;
  bool enable_rosout_ = true;
  bool use_intra_process_comms_ = false;
  detail::TopicStatisticsSetting topic_statistics_ = TopicStatisticsState::Disable;
  bool start_parameter_services_ = true;
  bool start_parameter_event_publisher_ = true;
  bool use_clock_thread_ = true;
  bool allow_undeclared_parameters_ = false;
  bool automatically_declare_parameters_from_overrides_ = false;
  decltype(&detail::make_logger_services) logger_services_ = nullptr;
  QoS clock_qos_ = ClockQoS();
  QoS parameter_event_qos_ = ParameterEventsQoS();
  QoS rosout_qos_ = RosoutQoS();
  rcl_clock_type_t clock_type_ = RCL_ROS_TIME;
};

}  // namespace rclcpp
