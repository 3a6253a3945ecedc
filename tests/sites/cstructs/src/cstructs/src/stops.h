#ifndef STOPS_H_
#define STOPS_H_

#include "cstructs/msg/route.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Append a stop; return false if there is no memory.
bool add_stop(cstructs__msg__Route * route, const char * name);
const rosidl_message_type_support_t * route_in_c(void);

#ifdef __cplusplus
}
#endif

#endif
