#ifndef RMW__ERROR_HANDLING_H_
#define RMW__ERROR_HANDLING_H_

#include "rcutils/error_handling.h"

typedef rcutils_error_string_t rmw_error_string_t;

#define rmw_get_error_string rcutils_get_error_string
#define rmw_reset_error rcutils_reset_error

#endif  /* RMW__ERROR_HANDLING_H_ */
