#ifndef RCL__TYPES_H_
#define RCL__TYPES_H_

#include "rmw/ret_types.h"
#include "rmw/serialized_message.h"

typedef rmw_ret_t rcl_ret_t;
typedef rmw_serialized_message_t rcl_serialized_message_t;

#define RCL_RET_OK RMW_RET_OK
#define RCL_RET_ERROR RMW_RET_ERROR
#define RCL_RET_TIMEOUT RMW_RET_TIMEOUT
#define RCL_RET_UNSUPPORTED RMW_RET_UNSUPPORTED
#define RCL_RET_BAD_ALLOC RMW_RET_BAD_ALLOC
#define RCL_RET_INVALID_ARGUMENT RMW_RET_INVALID_ARGUMENT

#endif  /* RCL__TYPES_H_ */
