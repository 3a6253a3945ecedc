// Exists because upstream has this header.
#pragma once

#include "tf2/convert.hpp"
