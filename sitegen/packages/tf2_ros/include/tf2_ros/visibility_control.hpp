#pragma once

// A program of a page is linked from static libraries: everything is visible.
#define TF2_ROS_PUBLIC
#define TF2_ROS_LOCAL
