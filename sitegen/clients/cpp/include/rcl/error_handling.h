#ifndef RCL__ERROR_HANDLING_H_
#define RCL__ERROR_HANDLING_H_

#include "rcutils/error_handling.h"

typedef rcutils_error_string_t rcl_error_string_t;

#define rcl_get_error_string rcutils_get_error_string
#define rcl_reset_error rcutils_reset_error

#endif  /* RCL__ERROR_HANDLING_H_ */
