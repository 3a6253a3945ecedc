// Exists because upstream has this header.
#pragma once

#include "rcpputils/env.hpp"
