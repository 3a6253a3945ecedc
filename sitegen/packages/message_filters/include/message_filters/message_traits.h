#pragma once

#include "message_filters/message_traits.hpp"
