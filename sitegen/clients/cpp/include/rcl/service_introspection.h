#ifndef RCL__SERVICE_INTROSPECTION_H_
#define RCL__SERVICE_INTROSPECTION_H_

/* What is published of the requests and responses of a service or a client. */
typedef enum rcl_service_introspection_state_e
{
  RCL_SERVICE_INTROSPECTION_OFF,
  RCL_SERVICE_INTROSPECTION_METADATA,
  RCL_SERVICE_INTROSPECTION_CONTENTS
} rcl_service_introspection_state_t;

#define RCL_SERVICE_INTROSPECTION_TOPIC_POSTFIX "/_service_event"

#endif  /* RCL__SERVICE_INTROSPECTION_H_ */
