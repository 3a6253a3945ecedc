/* The host functions: all that a compiled node asks of the page. docs/protocol.md describes them.
 * JavaScript's side is src/platform/host.js, which passes each call to the worker that runs the node. */
#ifndef RCLCPP__DETAIL__HOST_H_
#define RCLCPP__DETAIL__HOST_H_

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {ROS_NODE = 0, ROS_PUBLISHER = 1, ROS_SUBSCRIPTION = 2, ROS_SERVICE = 3, ROS_CLIENT = 4};
enum {ROS_RELIABLE = 1, ROS_TRANSIENT_LOCAL = 2, ROS_KEEP_ALL = 4, ROS_MANUAL_BY_TOPIC = 8};
enum
{
  ROS_EVENT_DEADLINE = 0,      /* missed: offered by a publisher, requested by a subscription */
  ROS_EVENT_LIVELINESS = 1,    /* lost by a publisher; changed, as a subscription sees it */
  ROS_EVENT_INCOMPATIBLE = 2,  /* an endpoint was found that would match, but for a policy */
  ROS_EVENT_MATCHED = 3,
  ROS_EVENT_LOST = 4,          /* messages that did not reach a subscription */
  ROS_EVENT_TYPE = 5           /* an endpoint was found that would match, but for its type */
};

typedef struct
{
  double deadline;  /* ms, infinity if there is none; the same for the next two */
  double lifespan;
  double lease;     /* of liveliness */
  int32_t depth;
  int32_t flags;    /* ROS_RELIABLE, … */
} ros_qos;

typedef struct
{
  int32_t total;           /* of liveliness changed: publishers that are not alive */
  int32_t total_change;    /* since it was told the last time */
  int32_t current;         /* matched endpoints; publishers that are alive */
  int32_t current_change;
  int32_t policy;          /* the last that was incompatible, as rmw numbers them */
} ros_event;

typedef struct
{
  double name;    /* which one it is: a whole number, unique in the page */
  ros_qos qos;
  int32_t kind;
  int32_t size;   /* with the texts behind it: a multiple of 8 */
} ros_entry;

typedef struct
{
  double source_timestamp;    /* when it was sent, ms since 1970 */
  double received_timestamp;  /* when it arrived here */
  double writer;              /* which endpoint sent it: a whole number, unique in the page */
  uint32_t sequence;          /* counts what its writer sent, from 1; that of the request in a response */
} ros_message_info;

/* Announce an endpoint and return its id (> 0). `node` is the node's fully qualified name. */
int32_t ros_create(
  int32_t kind, const char * node, const char * name, const char * type, const ros_qos * qos);
void ros_destroy(int32_t id);
/* Which endpoint of the whole page it is: a whole number. */
double ros_name(int32_t id);
/* Returns 0 if the publisher keeps all and is full: its subscriptions must take some first. */
int32_t ros_publish(int32_t id, const uint8_t * data, uint32_t size);
/* Give a subscription only messages that pass a content filter, all of them if `expression` is empty.
 * `definition` is that of its type, as in message_type_support.hpp; of `count` parameters, each ends with
 * a zero. Returns 0, or the size of the text written to `problem` (at most `capacity`) that says what is
 * wrong, or -1 if it has to be asked again after a wait. */
int32_t ros_filter(
  int32_t id, const char * definition, const char * expression, const char * parameters,
  int32_t count, char * problem, int32_t capacity);
/* Whether some reliable subscription has not yet got all that a publisher sent. */
int32_t ros_behind(int32_t id);
/* Say that a publisher is alive. */
void ros_assert(int32_t id);
/* How many events there were so far, of all endpoints of this program. */
uint32_t ros_events(void);
/* Tell what happened at an endpoint since the last time it was asked; returns 0 if nothing did. */
int32_t ros_take_event(int32_t id, int32_t kind, ros_event * event);
/* Send a request from a client to a server that matches; returns the number of its response. */
uint32_t ros_request(int32_t id, const uint8_t * data, uint32_t size);
/* Send a response from a server to the writer of a request, with that request's sequence. */
void ros_respond(
  int32_t id, double client, uint32_t sequence, const uint8_t * data, uint32_t size);
/* How many endpoints at the other side match this one now. */
int32_t ros_matched(int32_t id);
/* Size of the oldest message that waits at a subscription, a service or a client, -1 if none does. */
int32_t ros_next(int32_t id, ros_message_info * info);
/* Copy that message to `to` (unless null) and remove it. */
void ros_take(int32_t id, uint8_t * to);
/* How often the graph changed. From the first call on, the page tells what others do. */
uint32_t ros_changes(void);
/* Size of a description of all that is in the graph, -1 while the page has not told. It stays as it
 * is until the next call. */
int32_t ros_look(void);
/* Copy that description to `to`: for each node and endpoint a ros_entry, and behind it three texts
 * that end with a zero: its node, its name, its type. */
void ros_read(uint8_t * to);
/* Suspend the caller until something happened or `milliseconds` passed: 0 lets the event loop
 * turn once, a negative number waits without end. Returns the signal that waits to be handled
 * (2, SIGINT, when the reader pressed Stop), 0 if none. */
int32_t ros_wait(double milliseconds);
/* The program reads what is typed: 0 whole lines, 1 whole lines that are not shown, 2 each key at once,
 * 3 Ctrl-C as a key, too. */
void ros_reading(int32_t keyboard);
/* Bytes of what was typed first and not yet read, 0 if it is the end, -1 if nothing was typed. */
int32_t ros_typed(void);
/* Copy as many of these bytes to `to` as fit in `capacity` and remove them; returns how many. */
int32_t ros_take_typed(uint8_t * to, int32_t capacity);
/* End all waits of this program. */
void ros_wake(void);
/* Call `entry` with `argument` as soon as the caller waits. It may wait as well: JSPI gives it a stack
 * of its own. Of the engine jspi only. */
void ros_spawn(void (* entry)(void * argument), void * argument);
/* Milliseconds since 1970, with fractions; never steps back. */
double ros_now(void);
/* One line of the log; severity as in rcutils (10 debug … 50 fatal), stamp as ros_now() has it. */
void ros_log(int32_t severity, const char * logger, const char * text, double stamp);
/* Copy argument `index` of the command line (0 is the program's name) to `to`, at most `capacity`
 * bytes, without a zero at its end. Returns its size, -1 if there is none. */
int32_t ros_argument(int32_t index, char * to, int32_t capacity);
/* An exception left main(): the program ends with this text. */
void ros_fail(const char * text);
/* Of programs built with --debug: an exception, known by its address, is thrown here; and it is the one
 * that the program ends by. */
void ros_thrown(const void * exception);
void ros_blame(const void * exception);

#ifdef __cplusplus
}
#endif

#endif  /* RCLCPP__DETAIL__HOST_H_ */
