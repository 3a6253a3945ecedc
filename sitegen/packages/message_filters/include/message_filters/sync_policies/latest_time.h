#pragma once

#include "message_filters/sync_policies/latest_time.hpp"
