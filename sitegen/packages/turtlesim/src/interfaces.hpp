// The interfaces of turtlesim. Up to Jazzy they are in `turtlesim` itself, later in `turtlesim_msgs`.
#pragma once

#ifdef TURTLESIM_MSGS
#include "turtlesim_msgs/action/rotate_absolute.hpp"
#include "turtlesim_msgs/msg/color.hpp"
#include "turtlesim_msgs/msg/pose.hpp"
#include "turtlesim_msgs/srv/kill.hpp"
#include "turtlesim_msgs/srv/set_pen.hpp"
#include "turtlesim_msgs/srv/spawn.hpp"
#include "turtlesim_msgs/srv/teleport_absolute.hpp"
#include "turtlesim_msgs/srv/teleport_relative.hpp"

namespace interfaces = turtlesim_msgs;
#else
#include "turtlesim/action/rotate_absolute.hpp"
#include "turtlesim/msg/color.hpp"
#include "turtlesim/msg/pose.hpp"
#include "turtlesim/srv/kill.hpp"
#include "turtlesim/srv/set_pen.hpp"
#include "turtlesim/srv/spawn.hpp"
#include "turtlesim/srv/teleport_absolute.hpp"
#include "turtlesim/srv/teleport_relative.hpp"

namespace interfaces = turtlesim;
#endif
