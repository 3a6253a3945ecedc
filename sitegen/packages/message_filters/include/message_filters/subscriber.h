#pragma once

#include "message_filters/subscriber.hpp"
