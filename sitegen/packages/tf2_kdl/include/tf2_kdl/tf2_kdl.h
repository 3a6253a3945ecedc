#pragma once

#include "tf2_kdl/tf2_kdl.hpp"
