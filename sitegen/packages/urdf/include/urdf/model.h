// A robot description, with its links, joints and materials.
#pragma once

#include <string>

#include "urdf/urdfdom_compatibility.h"
#include "urdf/visibility_control.hpp"
#include "urdf_model/model.h"

namespace urdf
{

// Reads URDF only: parsers of other formats, which are plugins upstream, are not loaded.
class Model : public ModelInterface
{
public:
  // Both return false after an error, which they print; the model is unchanged.
  bool initFile(const std::string & filename);
  bool initString(const std::string & xml);
};

}  // namespace urdf
