// Makes trees of KDL of robot descriptions.
#pragma once

#include <string>

#include "kdl/tree.hpp"
#include "kdl_parser/visibility_control.hpp"
#include "urdf_model/model.h"

namespace kdl_parser
{

// The functions return false after an error in the description, which they print.
bool treeFromFile(const std::string & file, KDL::Tree & tree);
bool treeFromString(const std::string & xml, KDL::Tree & tree);
bool treeFromUrdfModel(const urdf::ModelInterface & robot_model, KDL::Tree & tree);

}  // namespace kdl_parser
