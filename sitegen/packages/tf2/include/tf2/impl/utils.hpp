// Upstream has a part of this here.
#pragma once

#include "tf2/utils.hpp"
