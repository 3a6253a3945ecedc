#pragma once

#include <cstddef>

namespace rclcpp
{

class InitOptions
{
public:
  bool shutdown_on_signal = true;

  InitOptions() = default;
  bool auto_initialize_logging() const {return initialize_logging_;}
  InitOptions & auto_initialize_logging(bool initialize_logging)
  {
    initialize_logging_ = initialize_logging;
    return *this;
  }
  void set_domain_id(std::size_t domain_id) {domain_id_ = domain_id;}
  /// Has no effect: a page has one graph.
  std::size_t get_domain_id() const {return domain_id_;}
  void use_default_domain_id() {domain_id_ = 0;}

private:
  bool initialize_logging_ = true;
  std::size_t domain_id_ = 0;
};

}  // namespace rclcpp
