#pragma once

#include "message_filters/connection.hpp"
