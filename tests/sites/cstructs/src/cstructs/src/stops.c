#include "stops.h"

#include "cstructs/action/drive.h"
#include "cstructs/srv/plan.h"
#include "rosidl_runtime_c/string_functions.h"

bool add_stop(cstructs__msg__Route * route, const char * name)
{
  cstructs__msg__Stop__Sequence more;
  const size_t size = route->stops.size;
  if (!cstructs__msg__Stop__Sequence__init(&more, size + 1)) {return false;}
  for (size_t i = 0; i < size; ++i) {
    if (!cstructs__msg__Stop__copy(&route->stops.data[i], &more.data[i])) {return false;}
  }
  cstructs__msg__Stop__Sequence__fini(&route->stops);
  route->stops = more;
  return rosidl_runtime_c__String__assign(&more.data[size].name, name);
}

const rosidl_message_type_support_t * route_in_c(void)
{
  return ROSIDL_GET_MSG_TYPE_SUPPORT(cstructs, msg, Route);
}
