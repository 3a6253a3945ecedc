#include "kdl_parser/kdl_parser.hpp"

#include "rcutils/logging_macros.h"
#include "urdf/model.h"

namespace kdl_parser
{

namespace
{

constexpr char LOGGER[] = "kdl_parser";

KDL::Frame frame_of(const urdf::Pose & pose)
{
  const auto & q = pose.rotation;
  const auto & p = pose.position;
  return {KDL::Rotation::Quaternion(q.x, q.y, q.z, q.w), KDL::Vector(p.x, p.y, p.z)};
}

KDL::Joint joint_of(const urdf::Joint & joint)
{
  const auto origin = frame_of(joint.parent_to_joint_origin_transform);
  const auto axis = origin.M * KDL::Vector(joint.axis.x, joint.axis.y, joint.axis.z);
  switch (joint.type) {
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return KDL::Joint(joint.name, origin.p, axis, KDL::Joint::RotAxis);
    case urdf::Joint::PRISMATIC:
      return KDL::Joint(joint.name, origin.p, axis, KDL::Joint::TransAxis);
    case urdf::Joint::FIXED:
      break;
    default:
      RCUTILS_LOG_WARN_NAMED(
        LOGGER, "Converting unknown joint type of joint '%s' into a fixed joint",
        joint.name.c_str());
  }
  return KDL::Joint(joint.name, KDL::Joint::None);
}

KDL::RigidBodyInertia inertia_of(const urdf::Inertial & inertial)
{
  const auto origin = frame_of(inertial.origin);
  const KDL::RotationalInertia about_center(
    inertial.ixx, inertial.iyy, inertial.izz, inertial.ixy, inertial.ixz, inertial.iyz);
  // URDF gives it along the axes of the inertial frame, KDL wants it along those of the link. Only
  // the inertia of a body can be rotated, so it is made one without mass.
  const auto rotated = origin.M * KDL::RigidBodyInertia(0, KDL::Vector::Zero(), about_center);
  return KDL::RigidBodyInertia(inertial.mass, origin.p, rotated.getRotationalInertia());
}

void add_children(const urdf::Link & link, KDL::Tree & tree)
{
  for (const auto & child : link.child_links) {
    const auto & joint = *child->parent_joint;
    const auto inertia = child->inertial ? inertia_of(*child->inertial) : KDL::RigidBodyInertia(0);
    const auto frame = frame_of(joint.parent_to_joint_origin_transform);
    tree.addSegment(KDL::Segment(child->name, joint_of(joint), frame, inertia), link.name);
    add_children(*child, tree);
  }
}

}  // namespace

bool treeFromFile(const std::string & file, KDL::Tree & tree)
{
  urdf::Model model;
  return model.initFile(file) && treeFromUrdfModel(model, tree);
}

bool treeFromString(const std::string & xml, KDL::Tree & tree)
{
  urdf::Model model;
  return model.initString(xml) && treeFromUrdfModel(model, tree);
}

bool treeFromUrdfModel(const urdf::ModelInterface & robot_model, KDL::Tree & tree)
{
  const auto root = robot_model.getRoot();
  if (!root) {
    return false;
  }
  if (root->inertial) {
    RCUTILS_LOG_WARN_NAMED(
      LOGGER,
      "The root link %s has an inertia specified in the URDF, but KDL does not support a root link "
      "with an inertia.  As a workaround, you can add an extra dummy link to your URDF.",
      root->name.c_str());
  }
  tree = KDL::Tree(root->name);
  add_children(*root, tree);
  return true;
}

}  // namespace kdl_parser
