/* rowe: JSON objects over WebSocket, for programs without ROS.
 *
 * Messages can expire, and calls wait for their reply. A service thread does the work; all functions
 * block an ordinary program only as long as they say, and can be called from all threads.
 *
 *   rowe_endpoint *robot = rowe_open_remote_endpoint("robot.local", 9090);
 *   struct json_object *request = json_tokener_parse("{\"a\": 38, \"b\": 4}");
 *   rowe_message *reply;
 *   if (rowe_invoke(robot, NULL, request, 5, &reply) == ROWE_OK) {
 *     puts(json_object_to_json_string(reply->body));
 *     rowe_free(reply);
 *   }
 *   json_object_put(request);
 *   rowe_close(robot);
 *
 * Compile the .c files beside this one, and link -lwebsockets -ljson-c -lpthread.
 */
#ifndef ROWE_H
#define ROWE_H

#include <json-c/json.h>
#include <math.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A time that does not end, for time to live and for timeouts (s). */
#define ROWE_FOREVER INFINITY

typedef struct rowe_endpoint rowe_endpoint;

/* A message that arrived. */
typedef struct {
  struct json_object *body; /* without the fields of rowe */
  char *peer;               /* the name of the sender */
  char *message_id;         /* NULL unless it is a request */
  char *in_reply_to;        /* NULL unless it is a reply */
  double time_to_live;      /* s */
} rowe_message;

enum rowe_result {
  ROWE_OK = 0,    /* sent, queued or answered */
  ROWE_DISCARDED, /* its time to live was over, or its peer is gone */
  ROWE_TIMEOUT,   /* no reply in time */
  ROWE_GONE,      /* the peer left before it replied */
  ROWE_FULL,      /* 10,000 messages, or 64 MB of them, wait for the peer */
  ROWE_INVALID,   /* not a JSON object, too long or too deep; or not a request */
  ROWE_NO_PEER,   /* no peer has this name, or there are several and none was named */
  ROWE_CLOSED,    /* the endpoint was closed meanwhile */
  ROWE_FAILED     /* the port is in use, or the URL is not one of a WebSocket */
};

/* What a result means, in words. */
const char *rowe_text(enum rowe_result result);

/* An endpoint without peers; one that accepts connections on 127.0.0.1; one that connects to a
 * server, and again after a lost connection. NULL if it is not possible. */
rowe_endpoint *rowe_open(void);
rowe_endpoint *rowe_open_local_endpoint(int port);
rowe_endpoint *rowe_open_remote_endpoint(const char *host, int port);

/* Close all connections; what waits to be sent is discarded. No other call may come after it. */
void rowe_close(rowe_endpoint *endpoint);

/* Accept connections: NULL as host is 127.0.0.1, and 0 as port any free one. */
enum rowe_result rowe_listen(rowe_endpoint *endpoint, const char *host, int port);
/* The port of the last rowe_listen, 0 before. */
int rowe_port(rowe_endpoint *endpoint);
/* Connect to ws://HOST[:PORT]/PATH. The peer gets this name; NULL is the URL. */
enum rowe_result rowe_connect(rowe_endpoint *endpoint, const char *url, const char *name);

/* The names of the connected peers, ended by NULL: one block of memory, to be given to free(). */
char **rowe_peers(rowe_endpoint *endpoint);

/* In all of these, `to` is the name of a peer; NULL if there is only one. The body stays yours. */

/* Block until the message was sent or discarded. */
enum rowe_result rowe_send(rowe_endpoint *endpoint, const char *to, struct json_object *body, double ttl);
/* Queue the message and return at once. */
enum rowe_result rowe_async_send(rowe_endpoint *endpoint, const char *to, struct json_object *body, double ttl);
/* Queue the message for all connected peers; return how many they are. */
int rowe_broadcast(rowe_endpoint *endpoint, struct json_object *body, double ttl);
/* Block until a message arrives; NULL after `timeout` seconds. Free it with rowe_free. */
rowe_message *rowe_receive(rowe_endpoint *endpoint, double timeout);
/* Send a request and block until its reply arrives. Only after ROWE_OK is there a reply to free. */
enum rowe_result rowe_invoke(rowe_endpoint *endpoint, const char *to, struct json_object *body, double timeout,
                             rowe_message **reply);
/* Reply to a request, as rowe_send and rowe_async_send do. */
enum rowe_result rowe_reply(rowe_endpoint *endpoint, const rowe_message *request, struct json_object *body, double ttl);
enum rowe_result rowe_async_reply(rowe_endpoint *endpoint, const rowe_message *request, struct json_object *body,
                                  double ttl);
void rowe_free(rowe_message *message);

#ifdef __cplusplus
}
#endif
#endif
