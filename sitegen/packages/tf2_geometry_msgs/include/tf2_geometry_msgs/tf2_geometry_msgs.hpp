#pragma once

#include "tf2_geometry_msgs/conversions.hpp"
#include "tf2_geometry_msgs/transforms.hpp"
