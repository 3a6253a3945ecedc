// A plugin for a package that this one needs, whose own programs load it.
#include <cmath>

#include "components/shape.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace family
{

class Round : public components::Shape
{
public:
  void initialize(double side) override {radius_ = side;}
  double area() const override {return M_PI * radius_ * radius_;}

private:
  double radius_ = 0;
};

}  // namespace family

PLUGINLIB_EXPORT_CLASS(family::Round, components::Shape)
