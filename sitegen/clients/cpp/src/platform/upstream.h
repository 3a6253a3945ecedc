// What upstream's headers include and those of the page do not: precompiled.py includes this file
// before sources that name parts of rclcpp without including their headers.
#pragma once

#ifdef __cplusplus
#include "standard.h"

#include "rclcpp/expand_topic_or_service_name.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rcpputils/filesystem_helper.hpp"
#include "rcpputils/join.hpp"
#include "rcpputils/pointer_traits.hpp"
#include "rcpputils/scope_exit.hpp"
#include "rcpputils/shared_library.hpp"
#include "rcpputils/time.hpp"
#endif
