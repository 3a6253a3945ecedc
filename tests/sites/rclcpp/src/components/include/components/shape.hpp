#pragma once

namespace components
{

class Shape
{
public:
  virtual ~Shape() = default;
  virtual void initialize(double side) = 0;
  virtual double area() const = 0;
};

}  // namespace components
