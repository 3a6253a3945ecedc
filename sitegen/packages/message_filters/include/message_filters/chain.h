#pragma once

#include "message_filters/chain.hpp"
