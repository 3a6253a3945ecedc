#pragma once

#include "message_filters/message_event.hpp"
