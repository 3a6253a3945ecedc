// Exists because upstream has this header.
#pragma once

#include "message_filters/parameter_adapter.hpp"
