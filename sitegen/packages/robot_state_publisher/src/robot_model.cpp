#include "robot_model/robot_model.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>

#include "robot_model/xml.hpp"

namespace robot_model
{
namespace
{

const std::set<std::string> kTypes{
  "fixed", "revolute", "continuous", "prismatic", "floating", "planar"};

double number(const std::string & text, const std::string & where)
{
  char * end;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end) {throw std::runtime_error(where + ": '" + text + "' is not a number");}
  return value;
}

tf2::Vector3 vector(const std::string & text, const std::string & where)
{
  std::istringstream words(text);
  std::string word;
  std::vector<double> values;
  while (words >> word) {values.push_back(number(word, where));}
  if (values.size() != 3) {throw std::runtime_error(where + ": '" + text + "' must be 3 numbers");}
  return tf2::Vector3(values[0], values[1], values[2]);
}

tf2::Transform origin_of(const Element & element, const std::string & where)
{
  const Element * origin = element.child("origin");
  if (!origin) {return tf2::Transform::getIdentity();}
  const tf2::Vector3 rpy = vector(origin->attribute("rpy", "0 0 0"), where);
  tf2::Quaternion rotation;
  rotation.setRPY(rpy.x(), rpy.y(), rpy.z());
  return tf2::Transform(rotation, vector(origin->attribute("xyz", "0 0 0"), where));
}

std::string needed(const Element * element, const char * attribute, const std::string & where)
{
  const std::string text = element ? element->attribute(attribute) : "";
  if (text.empty()) {throw std::runtime_error(where + ": '" + attribute + "' is missing");}
  return text;
}

std::string link_of(const Element & joint, const char * which, const std::string & where)
{
  return needed(joint.child(which), "link", where + " <" + which + ">");
}

Joint joint_of(const Element & element)
{
  Joint joint;
  joint.name = needed(&element, "name", "a joint");
  const std::string where = "joint '" + joint.name + "'";
  joint.type = needed(&element, "type", where);
  if (!kTypes.count(joint.type)) {
    throw std::runtime_error(where + " has an unknown type: '" + joint.type + "'");
  }
  joint.parent = link_of(element, "parent", where);
  joint.child = link_of(element, "child", where);
  joint.origin = origin_of(element, where);
  const Element * axis = element.child("axis");
  joint.axis = axis ? vector(axis->attribute("xyz", "1 0 0"), where) : tf2::Vector3(1, 0, 0);
  if (joint.moves() && joint.axis.isZero()) {
    throw std::runtime_error(where + " has an axis of length 0");
  }
  const Element * limit = element.child("limit");
  joint.lower = limit ? number(limit->attribute("lower", "0"), where) : 0;
  joint.upper = limit ? number(limit->attribute("upper", "0"), where) : 0;
  if (const Element * mimic = element.child("mimic")) {
    joint.mimic = Mimic{
      needed(mimic, "joint", where + " <mimic>"),
      number(mimic->attribute("multiplier", "1"), where),
      number(mimic->attribute("offset", "0"), where)};
  }
  return joint;
}

}  // namespace

bool Joint::moves() const
{
  return type == "revolute" || type == "continuous" || type == "prismatic";
}

tf2::Transform Joint::pose(double position) const
{
  if (!moves()) {return origin;}
  if (type == "prismatic") {
    return origin * tf2::Transform(tf2::Quaternion::getIdentity(), axis.normalized() * position);
  }
  return origin * tf2::Transform(tf2::Quaternion(axis, position));
}

Model parse_urdf(const std::string & text)
{
  const Element robot = parse_xml(text);
  if (robot.name != "robot") {throw std::runtime_error("expected <robot>, found <" + robot.name + ">");}
  Model model{robot.attribute("name"), "", false, {}, {}};
  std::map<std::string, const Element *> links;
  for (const Element & each : robot.children) {
    if (each.name == "link" && !links.emplace(needed(&each, "name", "a link"), &each).second) {
      throw std::runtime_error("link '" + each.attribute("name") + "' is not unique");
    }
  }
  std::set<std::string> children;
  for (const Element & each : robot.children) {
    if (each.name != "joint") {continue;}  // a <joint> inside <transmission> is not a joint of the robot
    Joint joint = joint_of(each);
    for (const std::string & link : {joint.parent, joint.child}) {
      if (!links.count(link)) {
        throw std::runtime_error("joint '" + joint.name + "': there is no link '" + link + "'");
      }
    }
    if (!children.insert(joint.child).second) {
      throw std::runtime_error("link '" + joint.child + "' has two parents");
    }
    model.order.push_back(joint.name);
    if (!model.joints.emplace(joint.name, joint).second) {
      throw std::runtime_error("joint '" + joint.name + "' is not unique");
    }
  }
  for (const auto & [name, element] : links) {
    if (children.count(name)) {continue;}
    if (!model.root.empty()) {
      throw std::runtime_error("there are two root links, '" + model.root + "' and '" + name + "'");
    }
    model.root = name;
    model.root_has_inertia = element->child("inertial");
  }
  if (model.root.empty()) {throw std::runtime_error("there is no root link");}
  return model;
}

}  // namespace robot_model
