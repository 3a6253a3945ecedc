// The kinematics of a robot description: links and the joints between them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tf2/LinearMath/Transform.hpp"
#include "tf2/LinearMath/Vector3.hpp"

namespace robot_model
{

/// A joint that follows another: its position is that of the other, times `multiplier`, plus `offset`.
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

  /// Whether the joint can move.
  bool moves() const;
  /// The transform from child to parent at a position in radians or metres.
  tf2::Transform pose(double position) const;
};

struct Model
{
  std::string name;
  std::string root;
  bool root_has_inertia;
  std::map<std::string, Joint> joints;
  std::vector<std::string> order;  // of the joints, as in the document
};

/// Parse a robot description. Throws std::runtime_error if it is invalid.
Model parse_urdf(const std::string & text);

}  // namespace robot_model
