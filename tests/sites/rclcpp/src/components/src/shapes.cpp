#include "components/shape.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace components
{

class Square : public Shape
{
public:
  void initialize(double side) override {side_ = side;}
  double area() const override {return side_ * side_;}

private:
  double side_ = 0;
};

}  // namespace components

PLUGINLIB_EXPORT_CLASS(components::Square, components::Shape)
