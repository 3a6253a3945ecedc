#pragma once

#include "message_filters/pass_through.hpp"
