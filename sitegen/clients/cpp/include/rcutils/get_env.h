// Exists because upstream has this header.
#pragma once

#include "rcutils/env.h"
