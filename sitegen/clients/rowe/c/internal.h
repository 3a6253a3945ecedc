/* What the functions of rowe.h (rowe.c) and the service thread (service.c) share. */
#ifndef ROWE_INTERNAL_H
#define ROWE_INTERNAL_H

#include <libwebsockets.h>
#include <pthread.h>

#include "message.h"
#include "queue.h"
#include "rowe.h"

#define ROWE_NAME 101     /* bytes of the name that a peer gives itself */
#define ROWE_INVALID_MAX 100 /* invalid messages of a connection; then it is closed */

/* A message to send. Whoever waits for it, and its queue, hold it; the last one frees it. */
struct outgoing {
  struct rowe_item item; /* must be first */
  struct rowe_endpoint *endpoint;
  char *text; /* after its '{', in `block` */
  char *block;
  size_t length;
  int holders;
  struct rowe_queue *queue; /* that it is in */
  enum { WAITING, SENT, DISCARDED } state;
};

/* A message that arrived. */
struct incoming {
  struct rowe_item item; /* must be first */
  rowe_message *message;
};

/* A call that waits for its reply. */
struct waiting {
  struct waiting *next;
  char id[33];
  struct peer *peer; /* NULL if there was none yet */
  rowe_message *reply;
  int gone;
};

struct peer {
  struct peer *next;
  struct rowe_endpoint *endpoint;
  char *name;
  char *host, *path; /* of the server; NULL if the peer has connected to us */
  int port;
  int wanted; /* the service thread shall connect */
  int attempt;
  double begun;
  lws_sorted_usec_list_t retry;
  struct lws *wsi; /* while there is a connection */
  struct rowe_queue queue;
  char *text; /* what arrived of a message in parts */
  size_t length;
  int invalid;
  int told, told_late, throttled;
};

struct rowe_endpoint {
  pthread_t thread;
  pthread_mutex_t lock; /* of all below, but for what only the service thread uses */
  pthread_cond_t arrived, changed;
  struct lws_context *context;
  struct json_tokener *parser;
  struct peer *peers;
  struct rowe_queue unaddressed; /* to "the" peer, before there is one */
  struct rowe_queue inbox;
  struct waiting *waiting;
  int numbers;
  int throttled; /* sockets are not read, because the inbox is full */
  lws_sorted_usec_list_t again;
  int closing;
  int calls; /* that are in the endpoint now: rowe_close waits for them */
  /* What rowe_listen asks of the service thread: 1 asked, 2 done. */
  int listening;
  const char *listen_host;
  int listen_port;
};

void *rowe_serve(void *endpoint);
int rowe_event(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in, size_t length);

/* With the lock held: */
struct peer *rowe_add_peer(rowe_endpoint *endpoint, const char *name);
void rowe_remove_peer(struct peer *peer);
void rowe_settle(struct outgoing *message, int state);
void rowe_drop_outgoing(struct rowe_item *item);
void rowe_drop_incoming(struct rowe_item *item);

#endif
