// Exists because upstream has this header.
#pragma once

#include "pluginlib/class_loader.hpp"
