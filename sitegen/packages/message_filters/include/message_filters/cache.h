#pragma once

#include "message_filters/cache.hpp"
