// A small XML parser for URDF: elements and attributes only.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace robot_model
{

struct Element
{
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;

  /// The first child with this name, or null.
  const Element * child(const std::string & wanted) const;
  /// The attribute, or `fallback` if there is none.
  std::string attribute(const std::string & wanted, const std::string & fallback = "") const;
};

/// Parse a document and return its root. Throws std::runtime_error with a line number.
Element parse_xml(const std::string & text);

}  // namespace robot_model
