// What the generated C headers of messages are made of: a table of the fields of each struct, and
// functions that work on any struct by its table. A program links only the functions that it uses.
#ifndef ROSIDL_TYPESUPPORT_SITEGEN_C__MESSAGE_H_
#define ROSIDL_TYPESUPPORT_SITEGEN_C__MESSAGE_H_

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "rosidl_runtime_c/action_type_support_struct.h"
#include "rosidl_runtime_c/message_type_support_struct.h"
#include "rosidl_runtime_c/primitives_sequence_functions.h"
#include "rosidl_runtime_c/service_type_support_struct.h"
#include "rosidl_runtime_c/string_functions.h"
#include "rosidl_runtime_c/type_hash.h"
#include "rosidl_runtime_c/u16string_functions.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct rosidl_sitegen__Struct rosidl_sitegen__Struct;

/// How many values a field has: one, `capacity`, up to `capacity`, or any number.
enum
{
  rosidl_sitegen__ONE, rosidl_sitegen__ARRAY, rosidl_sitegen__BOUNDED, rosidl_sitegen__UNBOUNDED
};

typedef struct rosidl_sitegen__Field
{
  size_t offset;  // in the struct, in bytes
  uint8_t type;  // of a single value: see type_description_interfaces/msg/FieldType
  uint8_t shape;
  size_t capacity;
  size_t bound;  // the maximum length of a single string, or 0
  const rosidl_sitegen__Struct * nested;
} rosidl_sitegen__Field;

struct rosidl_sitegen__Struct
{
  const rosidl_sitegen__Field * fields;
  size_t count;  // of fields
  size_t size;  // of the struct, in bytes
  /// Set the fields that have a default value; NULL if none has. The others are initialized.
  bool (* set_defaults)(void * message);
};

/// Any `…__Sequence` of messages.
typedef struct rosidl_sitegen__Sequence
{
  void * data;
  size_t size;
  size_t capacity;
} rosidl_sitegen__Sequence;

/// The data of a type support, which has the layout of MessageMembers in message_type_support.hpp.
typedef struct rosidl_sitegen__Members
{
  const char * name;
  const char * hash;
  const char * definition;
  void (* visit)(void * cdr, void * message);
  void * (* create)(void);
  void (* destroy)(void * message);
} rosidl_sitegen__Members;

bool rosidl_sitegen__init(const rosidl_sitegen__Struct * type, void * message);
void rosidl_sitegen__fini(const rosidl_sitegen__Struct * type, void * message);
void * rosidl_sitegen__create(const rosidl_sitegen__Struct * type);
void rosidl_sitegen__destroy(const rosidl_sitegen__Struct * type, void * message);
bool rosidl_sitegen__are_equal(
  const rosidl_sitegen__Struct * type, const void * left, const void * right);
bool rosidl_sitegen__copy(const rosidl_sitegen__Struct * type, const void * input, void * output);
bool rosidl_sitegen__sequence_init(
  const rosidl_sitegen__Struct * type, void * sequence, size_t size);
void rosidl_sitegen__sequence_fini(const rosidl_sitegen__Struct * type, void * sequence);
void * rosidl_sitegen__sequence_create(const rosidl_sitegen__Struct * type, size_t size);
void rosidl_sitegen__sequence_destroy(const rosidl_sitegen__Struct * type, void * sequence);
bool rosidl_sitegen__sequences_are_equal(
  const rosidl_sitegen__Struct * type, const void * left, const void * right);
bool rosidl_sitegen__sequence_copy(
  const rosidl_sitegen__Struct * type, const void * input, void * output);
/// Measure, write or read `message`; `cdr` is a rosidl_typesupport_sitegen_cpp::Cdr.
void rosidl_sitegen__visit(const rosidl_sitegen__Struct * type, void * cdr, void * message);

// Programs have no descriptions of types; native ROS 2 can be built without them, too.
extern const rosidl_runtime_c__type_description__TypeDescription rosidl_sitegen__description;
extern const rosidl_runtime_c__type_description__TypeSource rosidl_sitegen__source;
extern const rosidl_runtime_c__type_description__TypeSource__Sequence rosidl_sitegen__sources;

#ifdef __cplusplus
}
#endif

#define ROSIDL_SITEGEN__INLINE static inline __attribute__((unused))
#define ROSIDL_SITEGEN__IDENTIFIER "rosidl_typesupport_sitegen_cpp"

// Define the table of a struct whose fields are in `T__fields`, and its type support.
#define ROSIDL_SITEGEN__MESSAGE(T, NAME, HASH, DEFINITION, SET_DEFAULTS, ...) \
  static const rosidl_sitegen__Struct T ## __table = { \
    T ## __fields, sizeof(T ## __fields) / sizeof(T ## __fields[0]), sizeof(T), SET_DEFAULTS}; \
  ROSIDL_SITEGEN__INTROSPECTION(T, message, __VA_ARGS__) \
  ROSIDL_SITEGEN__INLINE void T ## __visit(void * cdr, void * message) \
  {rosidl_sitegen__visit(&T ## __table, cdr, message);} \
  ROSIDL_SITEGEN__INLINE void * T ## __make(void) {return rosidl_sitegen__create(&T ## __table);} \
  ROSIDL_SITEGEN__INLINE void T ## __drop(void * message) \
  {rosidl_sitegen__destroy(&T ## __table, message);} \
  ROSIDL_SITEGEN__INLINE const rosidl_message_type_support_t * \
  rosidl_typesupport_c__get_message_type_support_handle__ ## T(void) \
  { \
    static const rosidl_sitegen__Members members = { \
      NAME, HASH, DEFINITION, T ## __visit, T ## __make, T ## __drop}; \
    static const rosidl_message_type_support_t handle = { \
      ROSIDL_SITEGEN__IDENTIFIER, &members, get_message_typesupport_handle_function, \
      T ## __get_type_hash, T ## __get_type_description, T ## __get_type_description_sources}; \
    return &handle; \
  }

// Define the functions that describe a type; the last arguments are the 32 bytes of its hash.
#define ROSIDL_SITEGEN__INTROSPECTION(T, KIND, ...) \
  ROSIDL_SITEGEN__INLINE const rosidl_type_hash_t * T ## __get_type_hash( \
    const rosidl_ ## KIND ## _type_support_t * handle) \
  { \
    static const rosidl_type_hash_t hash = {1, {__VA_ARGS__}}; \
    (void)handle; \
    return &hash; \
  } \
  ROSIDL_SITEGEN__INLINE const rosidl_runtime_c__type_description__TypeDescription * \
  T ## __get_type_description(const rosidl_ ## KIND ## _type_support_t * handle) \
  {(void)handle; return &rosidl_sitegen__description;} \
  ROSIDL_SITEGEN__INLINE const rosidl_runtime_c__type_description__TypeSource * \
  T ## __get_individual_type_description_source(const rosidl_ ## KIND ## _type_support_t * handle) \
  {(void)handle; return &rosidl_sitegen__source;} \
  ROSIDL_SITEGEN__INLINE const rosidl_runtime_c__type_description__TypeSource__Sequence * \
  T ## __get_type_description_sources(const rosidl_ ## KIND ## _type_support_t * handle) \
  {(void)handle; return &rosidl_sitegen__sources;}

// Define the type support of a service, after those of its messages.
#define ROSIDL_SITEGEN__SERVICE(T, ...) \
  ROSIDL_SITEGEN__INTROSPECTION(T, service, __VA_ARGS__) \
  ROSIDL_SITEGEN__INLINE bool rosidl_typesupport_c__destroy_service_event_message__ ## T( \
    void * message, rcutils_allocator_t * allocator) \
  { \
    if (!message || !allocator) {return false;} \
    rosidl_sitegen__fini(&T ## _Event__table, message); \
    allocator->deallocate(message, allocator->state); \
    return true; \
  } \
  ROSIDL_SITEGEN__INLINE void * rosidl_typesupport_c__create_service_event_message__ ## T( \
    const rosidl_service_introspection_info_t * info, rcutils_allocator_t * allocator, \
    const void * request, const void * response) \
  { \
    T ## _Event * event; \
    if (!info || !allocator) {return NULL;} \
    event = (T ## _Event *)allocator->zero_allocate(1, sizeof(*event), allocator->state); \
    if (!event) {return NULL;} \
    if (!rosidl_sitegen__init(&T ## _Event__table, event) || \
      (request && !(rosidl_sitegen__sequence_init(&T ## _Request__table, &event->request, 1) && \
      rosidl_sitegen__copy(&T ## _Request__table, request, event->request.data))) || \
      (response && !(rosidl_sitegen__sequence_init(&T ## _Response__table, &event->response, 1) && \
      rosidl_sitegen__copy(&T ## _Response__table, response, event->response.data)))) \
    { \
      rosidl_typesupport_c__destroy_service_event_message__ ## T(event, allocator); \
      return NULL; \
    } \
    event->info.event_type = info->event_type; \
    event->info.sequence_number = info->sequence_number; \
    event->info.stamp.sec = info->stamp_sec; \
    event->info.stamp.nanosec = info->stamp_nanosec; \
    memcpy(event->info.client_gid, info->client_gid, sizeof(info->client_gid)); \
    return event; \
  } \
  ROSIDL_SITEGEN__INLINE const rosidl_service_type_support_t * \
  rosidl_typesupport_c__get_service_type_support_handle__ ## T(void) \
  { \
    static rosidl_service_type_support_t handle = { \
      ROSIDL_SITEGEN__IDENTIFIER, NULL, get_service_typesupport_handle_function, NULL, NULL, NULL, \
      rosidl_typesupport_c__create_service_event_message__ ## T, \
      rosidl_typesupport_c__destroy_service_event_message__ ## T, \
      T ## __get_type_hash, T ## __get_type_description, T ## __get_type_description_sources}; \
    handle.request_typesupport = \
      rosidl_typesupport_c__get_message_type_support_handle__ ## T ## _Request(); \
    handle.response_typesupport = \
      rosidl_typesupport_c__get_message_type_support_handle__ ## T ## _Response(); \
    handle.event_typesupport = \
      rosidl_typesupport_c__get_message_type_support_handle__ ## T ## _Event(); \
    return &handle; \
  }

// Define the type support of an action, after those of its messages and services.
#define ROSIDL_SITEGEN__ACTION(T, ...) \
  ROSIDL_SITEGEN__INTROSPECTION(T, action, __VA_ARGS__) \
  ROSIDL_SITEGEN__INLINE const rosidl_action_type_support_t * \
  rosidl_typesupport_c__get_action_type_support_handle__ ## T(void) \
  { \
    static rosidl_action_type_support_t handle = { \
      NULL, NULL, NULL, NULL, NULL, \
      T ## __get_type_hash, T ## __get_type_description, T ## __get_type_description_sources}; \
    handle.goal_service_type_support = \
      rosidl_typesupport_c__get_service_type_support_handle__ ## T ## _SendGoal(); \
    handle.result_service_type_support = \
      rosidl_typesupport_c__get_service_type_support_handle__ ## T ## _GetResult(); \
    handle.cancel_service_type_support = \
      rosidl_typesupport_c__get_service_type_support_handle__action_msgs__srv__CancelGoal(); \
    handle.feedback_message_type_support = \
      rosidl_typesupport_c__get_message_type_support_handle__ ## T ## _FeedbackMessage(); \
    handle.status_message_type_support = \
      rosidl_typesupport_c__get_message_type_support_handle__action_msgs__msg__GoalStatusArray(); \
    return &handle; \
  }

// Define the functions of a struct, with the names and the semantics of rosidl_generator_c.
#define ROSIDL_SITEGEN__FUNCTIONS(T) \
  ROSIDL_SITEGEN__INLINE bool T ## __init(T * message) \
  {return rosidl_sitegen__init(&T ## __table, message);} \
  ROSIDL_SITEGEN__INLINE void T ## __fini(T * message) \
  {rosidl_sitegen__fini(&T ## __table, message);} \
  ROSIDL_SITEGEN__INLINE T * T ## __create(void) \
  {return (T *)rosidl_sitegen__create(&T ## __table);} \
  ROSIDL_SITEGEN__INLINE void T ## __destroy(T * message) \
  {rosidl_sitegen__destroy(&T ## __table, message);} \
  ROSIDL_SITEGEN__INLINE bool T ## __are_equal(const T * left, const T * right) \
  {return rosidl_sitegen__are_equal(&T ## __table, left, right);} \
  ROSIDL_SITEGEN__INLINE bool T ## __copy(const T * input, T * output) \
  {return rosidl_sitegen__copy(&T ## __table, input, output);} \
  ROSIDL_SITEGEN__INLINE bool T ## __Sequence__init(T ## __Sequence * sequence, size_t size) \
  {return rosidl_sitegen__sequence_init(&T ## __table, sequence, size);} \
  ROSIDL_SITEGEN__INLINE void T ## __Sequence__fini(T ## __Sequence * sequence) \
  {rosidl_sitegen__sequence_fini(&T ## __table, sequence);} \
  ROSIDL_SITEGEN__INLINE T ## __Sequence * T ## __Sequence__create(size_t size) \
  {return (T ## __Sequence *)rosidl_sitegen__sequence_create(&T ## __table, size);} \
  ROSIDL_SITEGEN__INLINE void T ## __Sequence__destroy(T ## __Sequence * sequence) \
  {rosidl_sitegen__sequence_destroy(&T ## __table, sequence);} \
  ROSIDL_SITEGEN__INLINE bool T ## __Sequence__are_equal( \
    const T ## __Sequence * left, const T ## __Sequence * right) \
  {return rosidl_sitegen__sequences_are_equal(&T ## __table, left, right);} \
  ROSIDL_SITEGEN__INLINE bool T ## __Sequence__copy( \
    const T ## __Sequence * input, T ## __Sequence * output) \
  {return rosidl_sitegen__sequence_copy(&T ## __table, input, output);}

#endif  // ROSIDL_TYPESUPPORT_SITEGEN_C__MESSAGE_H_
