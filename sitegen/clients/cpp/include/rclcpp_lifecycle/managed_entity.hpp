#pragma once

#include "rclcpp/macros.hpp"

namespace rclcpp_lifecycle
{

/// An entity that a lifecycle node activates and deactivates with itself.
class ManagedEntityInterface
{
public:
  virtual ~ManagedEntityInterface() = default;
  virtual void on_activate() = 0;
  virtual void on_deactivate() = 0;
};

class SimpleManagedEntity : public ManagedEntityInterface
{
public:
  void on_activate() override {activated_ = true;}
  void on_deactivate() override {activated_ = false;}
  bool is_activated() const {return activated_;}

private:
  bool activated_ = false;
};

}  // namespace rclcpp_lifecycle
