// Exists because upstream has this header.
#pragma once

#include "message_filters/null_types.hpp"
