/* The host functions, the interface of a compiled node to the page; see docs/protocol.md.
 * src/platform/host.js forwards each call to the worker that runs the node. */
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
  ROS_EVENT_INCOMPATIBLE = 2,  /* an endpoint of the topic has incompatible QoS */
  ROS_EVENT_MATCHED = 3,
  ROS_EVENT_LOST = 4,          /* messages that a subscription lost */
  ROS_EVENT_TYPE = 5           /* an endpoint of the topic has another type */
};

typedef struct
{
  double deadline;  /* ms, infinity if unspecified; so are the next two */
  double lifespan;
  double lease;     /* of liveliness */
  int32_t depth;
  int32_t flags;    /* ROS_RELIABLE, … */
} ros_qos;

typedef struct
{
  int32_t total;           /* for liveliness changed: publishers that are not alive */
  int32_t total_change;    /* since the last report */
  int32_t current;         /* matched endpoints; publishers that are alive */
  int32_t current_change;
  int32_t policy;          /* the last incompatible policy, as numbered by rmw */
} ros_event;

typedef struct
{
  double gid;     /* an integer, unique in the page */
  ros_qos qos;
  int32_t kind;
  int32_t size;   /* including the strings that follow: a multiple of 8 */
} ros_entry;

typedef struct
{
  double source_timestamp;    /* when it was sent, ms since 1970 */
  double received_timestamp;  /* when it arrived here */
  double writer_gid;          /* the gid of the sender */
  uint32_t sequence;          /* sequence number of the writer, from 1; in a response, of the request */
} ros_message_info;

/* Announce an endpoint and return its id (> 0). `node` is the node's fully qualified name. */
int32_t ros_create(
  int32_t kind, const char * node, const char * name, const char * type, const ros_qos * qos);
void ros_destroy(int32_t id);
/* The gid of an endpoint. */
double ros_gid(int32_t id);
/* Publish a message. Returns 0 if the history is KEEP_ALL and the queues of subscriptions are full. */
int32_t ros_publish(int32_t id, const uint8_t * data, uint32_t size);
/* Set the content filter of a subscription; an empty `expression` removes it.
 * `definition` is that of its type, as in message_type_support.hpp; each of `count` parameters ends with
 * a zero. Returns 0, or the size of the error message written to `problem` (at most `capacity`), or -1
 * if the caller must wait and try again. */
int32_t ros_filter(
  int32_t id, const char * definition, const char * expression, const char * parameters,
  int32_t count, char * problem, int32_t capacity);
/* Whether a reliable subscription has not yet received all messages of a publisher. */
int32_t ros_behind(int32_t id);
/* Assert the liveliness of a publisher. */
void ros_assert(int32_t id);
/* The number of events so far, of all endpoints of this program. */
uint32_t ros_events(void);
/* Get the status of an event since the last call; returns 0 if nothing has happened. */
int32_t ros_take_event(int32_t id, int32_t kind, ros_event * event);
/* Send a request from a client to a matched server; returns its sequence number. */
uint32_t ros_request(int32_t id, const uint8_t * data, uint32_t size);
/* Send a response to the client with this gid, with the sequence number of its request. */
void ros_respond(
  int32_t id, double client, uint32_t sequence, const uint8_t * data, uint32_t size);
/* The number of matched endpoints. */
int32_t ros_matched(int32_t id);
/* The size of the oldest message of a subscription, a service or a client, -1 if there is none. */
int32_t ros_next(int32_t id, ros_message_info * info);
/* Copy that message to `to` (unless null) and remove it. */
void ros_take(int32_t id, uint8_t * to);
/* The number of graph changes. The first call makes the page report changes of other programs. */
uint32_t ros_changes(void);
/* The size of a description of the graph, -1 if the page has not sent it yet. It does not change
 * until the next call. */
int32_t ros_look(void);
/* Copy that description to `to`: for each node and endpoint a ros_entry, followed by three strings
 * that end with a zero: node, name and type. */
void ros_read(uint8_t * to);
/* Suspend the caller until something happens or `milliseconds` pass: 0 yields to the event loop
 * once, a negative number sets no limit. Returns the pending signal (2, SIGINT, for Stop), 0 if
 * there is none. */
int32_t ros_wait(double milliseconds);
/* Start reading the keyboard: 0 whole lines, 1 whole lines without echo, 2 each key, 3 each key and
 * Ctrl-C as a key. */
void ros_reading(int32_t keyboard);
/* The size of the oldest unread input, 0 at the end of input, -1 if there is none. */
int32_t ros_typed(void);
/* Copy up to `capacity` of these bytes to `to` and remove them; returns their number. */
int32_t ros_take_typed(uint8_t * to, int32_t capacity);
/* Ask for the content of the file at `path`, relative to the open folder `folder`. 0 if it is there,
 * or is not a file of a package, 1 if it is being loaded: then all waits end. A negative error
 * number if it cannot be loaded. A file that is truncated needs no content. */
int32_t ros_open(int32_t folder, const char * path, int32_t truncated);
/* End all waits of this program. */
void ros_wake(void);
/* Call `entry` with `argument` when the caller waits. It may wait as well: JSPI gives it its own
 * stack. For the engine jspi only. */
void ros_spawn(void (* entry)(void * argument), void * argument);
/* Suspend the caller until another call switches to `from`. Meanwhile, resume the call that switched
 * away from `to`, or call `entry` with `to` as ros_spawn() does. For the engine jspi only. */
void ros_swap(void * from, void * to, void (* entry)(void * to));
/* Milliseconds since 1970, with fractions; never goes backwards. */
double ros_now(void);
/* Write a log message; severity as in rcutils (10 debug … 50 fatal), stamp as of ros_now(). */
void ros_log(int32_t severity, const char * logger, const char * text, double stamp);
/* Copy argument `index` of the command line (0 is the program's name) to `to`, at most `capacity`
 * bytes, without a zero at its end. Returns its size, -1 if there is none. */
int32_t ros_argument(int32_t index, char * to, int32_t capacity);
/* End the program with this message: an exception has left main(). */
void ros_fail(const char * text);
/* For programs built with --debug: report where an exception, identified by its address, is thrown,
 * and that it ends the program. */
void ros_thrown(const void * exception);
void ros_blame(const void * exception);

#ifdef __cplusplus
}
#endif

#endif  /* RCLCPP__DETAIL__HOST_H_ */
