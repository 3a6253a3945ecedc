#pragma once

#include "tf2_ros/buffer_client.hpp"
