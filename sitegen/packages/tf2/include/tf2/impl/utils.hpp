// Exists because upstream has this header.
#pragma once

#include "tf2/utils.hpp"
