/* All that there is of rcl. */
#ifndef RCL__RCL_H_
#define RCL__RCL_H_

#include "rcl/allocator.h"
#include "rcl/error_handling.h"
#include "rcl/service_introspection.h"
#include "rcl/time.h"
#include "rcl/types.h"
#include "rcl/wait.h"

#endif  /* RCL__RCL_H_ */
