#define _GNU_SOURCE
#include "rowe.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>

#include "internal.h"

const char *rowe_text(enum rowe_result result) {
  static const char *const TEXTS[] = {
      "done",
      "discarded: its time was over, or its peer is gone",
      "no reply in time",
      "the peer left before it replied",
      "too many messages wait for the peer",
      "not a JSON object, too long or too deep, or not a request",
      "no peer has this name, or name one of several",
      "the endpoint was closed",
      "the port is in use, or this is not the URL of a WebSocket",
  };
  return (unsigned)result < sizeof TEXTS / sizeof *TEXTS ? TEXTS[result] : "unknown";
}

/* Wait for a condition, with the lock held, until a time by rowe_now(). Return 0 when it is over. */
static int wait_until(pthread_cond_t *condition, pthread_mutex_t *lock, double end) {
  if (end > 1e9) return pthread_cond_wait(condition, lock) == 0;
  struct timespec at = {(time_t)end, (long)((end - floor(end)) * 1e9)};
  return pthread_cond_timedwait(condition, lock, &at) != ETIMEDOUT;
}

void rowe_settle(struct outgoing *message, int state) {
  message->state = state;
  pthread_cond_broadcast(&message->endpoint->changed);
  if (--message->holders) return;
  free(message->block);
  free(message);
}

void rowe_drop_outgoing(struct rowe_item *item) {
  struct outgoing *message = (struct outgoing *)item;
  message->queue = NULL;
  rowe_settle(message, DISCARDED);
}

void rowe_drop_incoming(struct rowe_item *item) {
  rowe_free(((struct incoming *)item)->message);
  free(item);
}

struct peer *rowe_add_peer(rowe_endpoint *endpoint, const char *name) {
  struct peer *peer = calloc(1, sizeof *peer);
  if (!peer) return NULL;
  peer->endpoint = endpoint;
  peer->name = strdup(name);
  rowe_queue_init(&peer->queue, rowe_drop_outgoing);
  struct peer **last = &endpoint->peers;
  while (*last) last = &(*last)->next;
  *last = peer;
  struct rowe_item *item;
  while ((item = rowe_queue_take(&endpoint->unaddressed))) {
    rowe_queue_put(&peer->queue, item);
    ((struct outgoing *)item)->queue = &peer->queue;
  }
  return peer;
}

void rowe_remove_peer(struct peer *peer) {
  rowe_endpoint *endpoint = peer->endpoint;
  struct peer **at = &endpoint->peers;
  while (*at != peer) at = &(*at)->next;
  *at = peer->next;
  for (struct waiting *call = endpoint->waiting; call; call = call->next)
    if (call->peer == peer) call->gone = 1;
  pthread_cond_broadcast(&endpoint->changed);
  rowe_queue_clear(&peer->queue);
  free(peer->name);
  free(peer->host);
  free(peer->path);
  free(peer->text);
  free(peer);
}

/* Each call is between these two: rowe_close waits until all calls have left. */
static void enter(rowe_endpoint *endpoint) {
  pthread_mutex_lock(&endpoint->lock);
  endpoint->calls++;
}

static void leave(rowe_endpoint *endpoint) {
  endpoint->calls--;
  if (endpoint->closing) pthread_cond_broadcast(&endpoint->changed);
  pthread_mutex_unlock(&endpoint->lock);
}

/* Find the peer that `to` means; `found` is NULL if there is none yet. With the lock held. */
static enum rowe_result find(rowe_endpoint *endpoint, const char *to, struct peer **found) {
  *found = endpoint->peers;
  if (!to) return endpoint->peers && endpoint->peers->next ? ROWE_NO_PEER : ROWE_OK;
  while (*found && strcmp((*found)->name, to)) *found = (*found)->next;
  return *found ? ROWE_OK : ROWE_NO_PEER;
}

/* Queue a message. With the lock held. */
static enum rowe_result put(rowe_endpoint *endpoint, struct peer *peer, struct outgoing *message) {
  struct rowe_queue *queue = peer ? &peer->queue : &endpoint->unaddressed;
  if (endpoint->closing) return ROWE_CLOSED;
  if (!rowe_queue_has_room(queue, message->item.weight)) return ROWE_FULL;
  message->holders++;
  message->queue = queue;
  rowe_queue_put(queue, &message->item);
  lws_cancel_service(endpoint->context);
  return ROWE_OK;
}

static struct outgoing *encode(rowe_endpoint *endpoint, struct json_object *body, const char *field, const char *value,
                               double ttl) {
  struct outgoing *message = ttl >= 0 ? calloc(1, sizeof *message) : NULL;
  if (!message) return NULL;
  message->endpoint = endpoint;
  message->block = rowe_encode(body, field, value, LWS_PRE + ROWE_TIME_ROOM, &message->length);
  if (!message->block) {
    free(message);
    return NULL;
  }
  message->text = message->block + LWS_PRE + ROWE_TIME_ROOM;
  message->item.expiry = rowe_now() + ttl;
  message->item.weight = message->length;
  message->holders = 1;
  return message;
}

static enum rowe_result post(rowe_endpoint *endpoint, const char *to, struct json_object *body, const char *field,
                             const char *value, double ttl, int blocks) {
  struct outgoing *message = encode(endpoint, body, field, value, ttl);
  if (!message) return ROWE_INVALID;
  enter(endpoint);
  struct peer *peer;
  enum rowe_result result = find(endpoint, to, &peer);
  /* The peer of a request may have left, which its program could not know. */
  if (result == ROWE_NO_PEER && field) result = ROWE_DISCARDED;
  if (!result) result = put(endpoint, peer, message);
  if (!result && blocks) {
    while (message->state == WAITING && wait_until(&endpoint->changed, &endpoint->lock, message->item.expiry)) continue;
    if (message->queue) {
      rowe_queue_remove(message->queue, &message->item);
      rowe_drop_outgoing(&message->item);
    }
    result = message->state == SENT ? ROWE_OK : ROWE_DISCARDED;
  }
  rowe_settle(message, message->state);
  leave(endpoint);
  return result;
}

enum rowe_result rowe_send(rowe_endpoint *endpoint, const char *to, struct json_object *body, double ttl) {
  return post(endpoint, to, body, NULL, NULL, ttl, 1);
}

enum rowe_result rowe_async_send(rowe_endpoint *endpoint, const char *to, struct json_object *body, double ttl) {
  return post(endpoint, to, body, NULL, NULL, ttl, 0);
}

enum rowe_result rowe_reply(rowe_endpoint *endpoint, const rowe_message *request, struct json_object *body,
                            double ttl) {
  if (!request->message_id) return ROWE_INVALID;
  return post(endpoint, request->peer, body, "in_reply_to", request->message_id, ttl, 1);
}

enum rowe_result rowe_async_reply(rowe_endpoint *endpoint, const rowe_message *request, struct json_object *body,
                                  double ttl) {
  if (!request->message_id) return ROWE_INVALID;
  return post(endpoint, request->peer, body, "in_reply_to", request->message_id, ttl, 0);
}

int rowe_broadcast(rowe_endpoint *endpoint, struct json_object *body, double ttl) {
  int count = 0;
  char **names = rowe_peers(endpoint);
  for (char **name = names; name && *name; name++) count += rowe_async_send(endpoint, *name, body, ttl) == ROWE_OK;
  free(names);
  return count;
}

enum rowe_result rowe_invoke(rowe_endpoint *endpoint, const char *to, struct json_object *body, double timeout,
                             rowe_message **reply) {
  struct waiting call = {0};
  unsigned char random[16];
  if (getrandom(random, sizeof random, 0) != sizeof random) return ROWE_FAILED;
  for (int i = 0; i < 16; i++) sprintf(call.id + 2 * i, "%02x", random[i]);
  struct outgoing *message = encode(endpoint, body, "message_id", call.id, timeout);
  if (!message) return ROWE_INVALID;
  double end = message->item.expiry;
  enter(endpoint);
  enum rowe_result result = find(endpoint, to, &call.peer);
  call.next = endpoint->waiting;
  endpoint->waiting = &call;
  if (!result) result = put(endpoint, call.peer, message);
  rowe_settle(message, message->state);
  while (!result && !call.reply) {
    if (endpoint->closing) result = ROWE_CLOSED;
    else if (call.gone) result = ROWE_GONE;
    else if (!wait_until(&endpoint->changed, &endpoint->lock, end) && !call.reply) result = ROWE_TIMEOUT;
  }
  struct waiting **at = &endpoint->waiting;
  while (*at != &call) at = &(*at)->next;
  *at = call.next;
  leave(endpoint);
  if (!result) *reply = call.reply;
  else rowe_free(call.reply);
  return result;
}

rowe_message *rowe_receive(rowe_endpoint *endpoint, double timeout) {
  double end = rowe_now() + timeout;
  struct rowe_item *item;
  enter(endpoint);
  while (!(item = rowe_queue_take(&endpoint->inbox)) && !endpoint->closing)
    if (!wait_until(&endpoint->arrived, &endpoint->lock, end)) {
      item = rowe_queue_take(&endpoint->inbox);
      break;
    }
  if (endpoint->throttled && !endpoint->closing) lws_cancel_service(endpoint->context);
  leave(endpoint);
  if (!item) return NULL;
  rowe_message *message = ((struct incoming *)item)->message;
  free(item);
  return message;
}

char **rowe_peers(rowe_endpoint *endpoint) {
  size_t count = 1, size = 0;
  pthread_mutex_lock(&endpoint->lock);
  for (struct peer *peer = endpoint->peers; peer; peer = peer->next)
    if (peer->wsi) count++, size += strlen(peer->name) + 1;
  char **names = malloc(count * sizeof *names + size);
  if (names) {
    char **next = names, *text = (char *)(names + count);
    for (struct peer *peer = endpoint->peers; peer; peer = peer->next)
      if (peer->wsi) {
        *next++ = strcpy(text, peer->name);
        text += strlen(text) + 1;
      }
    *next = NULL;
  }
  pthread_mutex_unlock(&endpoint->lock);
  return names;
}

enum rowe_result rowe_listen(rowe_endpoint *endpoint, const char *host, int port) {
  pthread_mutex_lock(&endpoint->lock);
  endpoint->listen_host = host ? host : "127.0.0.1";
  endpoint->listen_port = port;
  endpoint->listening = 1;
  lws_cancel_service(endpoint->context);
  while (endpoint->listening == 1 && !endpoint->closing) pthread_cond_wait(&endpoint->changed, &endpoint->lock);
  enum rowe_result result = endpoint->listen_port > 0 ? ROWE_OK : ROWE_FAILED;
  pthread_mutex_unlock(&endpoint->lock);
  return result;
}

int rowe_port(rowe_endpoint *endpoint) { return endpoint->listening == 2 ? endpoint->listen_port : 0; }

enum rowe_result rowe_connect(rowe_endpoint *endpoint, const char *url, const char *name) {
  const char *protocol, *host, *path;
  int port = 0;
  char *parts = strdup(url);
  if (!parts || strncmp(url, "ws://", 5) || lws_parse_uri(parts, &protocol, &host, &port, &path) || !*host) {
    free(parts);
    return ROWE_FAILED;
  }
  struct peer *peer = NULL, *other;
  pthread_mutex_lock(&endpoint->lock);
  if (find(endpoint, name ? name : url, &other) == ROWE_NO_PEER) peer = rowe_add_peer(endpoint, name ? name : url);
  if (peer) {
    peer->host = strdup(host);
    if (asprintf(&peer->path, "%s%s", *path == '/' ? "" : "/", path) < 0) peer->path = NULL;
    peer->port = port;
    peer->wanted = 1;
    lws_cancel_service(endpoint->context);
  }
  pthread_mutex_unlock(&endpoint->lock);
  free(parts);
  return peer ? ROWE_OK : ROWE_FAILED;
}

rowe_endpoint *rowe_open(void) {
  static const struct lws_protocols PROTOCOLS[] = {{"rowe", rowe_event, ROWE_NAME, 65536, 0, NULL, 0}, {0}};
  rowe_endpoint *endpoint = calloc(1, sizeof *endpoint);
  if (!endpoint) return NULL;
  pthread_condattr_t monotonic;
  pthread_condattr_init(&monotonic);
  pthread_condattr_setclock(&monotonic, CLOCK_MONOTONIC);
  pthread_mutex_init(&endpoint->lock, NULL);
  pthread_cond_init(&endpoint->arrived, &monotonic);
  pthread_cond_init(&endpoint->changed, &monotonic);
  pthread_condattr_destroy(&monotonic);
  rowe_queue_init(&endpoint->unaddressed, rowe_drop_outgoing);
  rowe_queue_init(&endpoint->inbox, rowe_drop_incoming);
  endpoint->parser = json_tokener_new_ex(ROWE_DEEPEST + 1);
  json_tokener_set_flags(endpoint->parser, JSON_TOKENER_STRICT | JSON_TOKENER_VALIDATE_UTF8);
  lws_set_log_level(LLL_ERR, NULL);
  struct lws_context_creation_info info = {0};
  info.port = CONTEXT_PORT_NO_LISTEN;
  info.protocols = PROTOCOLS;
  info.gid = (gid_t)-1;
  info.uid = (uid_t)-1;
  info.user = endpoint;
  endpoint->context = lws_create_context(&info);
  if (!endpoint->context || pthread_create(&endpoint->thread, NULL, rowe_serve, endpoint)) {
    fprintf(stderr, "rowe: cannot start\n");
    abort();
  }
  return endpoint;
}

rowe_endpoint *rowe_open_local_endpoint(int port) {
  rowe_endpoint *endpoint = rowe_open();
  if (!endpoint || !rowe_listen(endpoint, NULL, port)) return endpoint;
  rowe_close(endpoint);
  return NULL;
}

rowe_endpoint *rowe_open_remote_endpoint(const char *host, int port) {
  char url[300];
  rowe_endpoint *endpoint = rowe_open();
  snprintf(url, sizeof url, strchr(host, ':') ? "ws://[%s]:%d/" : "ws://%s:%d/", host, port);
  if (!endpoint || !rowe_connect(endpoint, url, NULL)) return endpoint;
  rowe_close(endpoint);
  return NULL;
}

void rowe_close(rowe_endpoint *endpoint) {
  pthread_mutex_lock(&endpoint->lock);
  endpoint->closing = 1;
  pthread_cond_broadcast(&endpoint->arrived);
  pthread_cond_broadcast(&endpoint->changed);
  lws_cancel_service(endpoint->context);
  pthread_mutex_unlock(&endpoint->lock);
  pthread_join(endpoint->thread, NULL);
  pthread_mutex_lock(&endpoint->lock);
  rowe_queue_clear(&endpoint->unaddressed);
  while (endpoint->calls) pthread_cond_wait(&endpoint->changed, &endpoint->lock);
  pthread_mutex_unlock(&endpoint->lock);
  rowe_queue_clear(&endpoint->inbox);
  json_tokener_free(endpoint->parser);
  pthread_cond_destroy(&endpoint->arrived);
  pthread_cond_destroy(&endpoint->changed);
  pthread_mutex_destroy(&endpoint->lock);
  free(endpoint);
}
