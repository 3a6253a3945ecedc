// What of a robot description is about motion: links, and the joints between them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tf2/LinearMath/Transform.hpp"
#include "tf2/LinearMath/Vector3.hpp"

namespace robot_model
{

/// One joint does what another does: its position is that one's, times `multiplier`, plus `offset`.
struct Mimic
{
  std::string joint;
  double multiplier;
  double offset;
};

struct Joint
{
  std::string name;
  std::string type;
  std::string parent;
  std::string child;
  tf2::Transform origin;
  tf2::Vector3 axis;
  double lower;
  double upper;
  std::optional<Mimic> mimic;

  /// Whether it has a position.
  bool moves() const;
  /// Where the child is in the parent, at a position in radians or meters.
  tf2::Transform pose(double position) const;
};

struct Model
{
  std::string name;
  std::string root;
  bool root_has_inertia;
  std::map<std::string, Joint> joints;
  std::vector<std::string> order;  // of the joints, as they are written
};

/// Read a robot description. Throws std::runtime_error with what is wrong with it.
Model parse_urdf(const std::string & text);

}  // namespace robot_model
