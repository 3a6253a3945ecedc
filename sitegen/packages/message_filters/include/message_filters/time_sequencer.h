#pragma once

#include "message_filters/time_sequencer.hpp"
