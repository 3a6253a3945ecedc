/* The service thread: connections, and what arrives over them and leaves by them. */
#define _GNU_SOURCE
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>

#include "internal.h"

/* Seconds between attempts to connect, the last repeated. */
static const double PAUSES[] = {0.1, 0.2, 0.5, 1, 2, 5};
#define LAST_PAUSE ((int)(sizeof PAUSES / sizeof *PAUSES) - 1)
/* Seconds of silence until a ping, and until the connection counts as lost. */
static const lws_retry_bo_t IDLE = {.secs_since_valid_ping = 15, .secs_since_valid_hangup = 23};
/* Seconds that what was sent has to leave when the endpoint is closed. */
#define FAREWELL 1

static void start_connecting(struct peer *peer) {
  struct lws_client_connect_info info = {0};
  char host[300];
  info.context = peer->endpoint->context;
  info.address = peer->host;
  info.port = peer->port;
  info.path = peer->path;
  snprintf(host, sizeof host, "%s:%d", peer->host, peer->port);
  info.host = host;
  info.origin = host;
  info.protocol = NULL;
  info.local_protocol_name = "rowe";
  info.opaque_user_data = peer;
  info.retry_and_idle_policy = &IDLE;
  /* An error comes as an event, too. */
  lws_client_connect_via_info(&info);
}

static void retry(lws_sorted_usec_list_t *list) { start_connecting(lws_container_of(list, struct peer, retry)); }

static void schedule(struct peer *peer) {
  if (peer->endpoint->closing) return;
  double pause = PAUSES[peer->attempt < LAST_PAUSE ? peer->attempt : LAST_PAUSE];
  peer->attempt++;
  /* Programs that lost the same server do not all come back in the same instant. */
  unsigned char chance = 0;
  if (getrandom(&chance, 1, 0) == 1) pause *= 0.75 + chance / 1024.0;
  lws_sul_schedule(peer->endpoint->context, 0, &peer->retry, retry, (lws_usec_t)(pause * 1e6));
}

static void listen_now(rowe_endpoint *endpoint) {
  struct lws_context_creation_info info = {0};
  const char *host = endpoint->listen_host;
  static const struct lws_protocols PROTOCOLS[] = {{"rowe", rowe_event, ROWE_NAME, 65536, 0, NULL, 0}, {0}};
  char name[24];
  snprintf(name, sizeof name, "rowe%d", endpoint->numbers++);
  info.vhost_name = name;
  info.port = endpoint->listen_port;
  info.iface = strcmp(host, "0.0.0.0") ? host : NULL;
  info.protocols = PROTOCOLS;
  info.retry_and_idle_policy = &IDLE;
  info.user = endpoint;
  info.options = LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND | LWS_SERVER_OPTION_VALIDATE_UTF8;
  if (!strchr(host, ':')) info.options |= LWS_SERVER_OPTION_DISABLE_IPV6;
  struct lws_vhost *vhost = lws_create_vhost(endpoint->context, &info);
  pthread_mutex_lock(&endpoint->lock);
  endpoint->listen_port = vhost ? lws_get_vhost_listen_port(vhost) : 0;
  endpoint->listening = 2;
  pthread_cond_broadcast(&endpoint->changed);
  pthread_mutex_unlock(&endpoint->lock);
}

/* Let sockets be read again when the inbox has room. With the lock held. */
static void look_for_room(rowe_endpoint *endpoint) {
  if (!endpoint->throttled || !rowe_queue_has_room(&endpoint->inbox, ROWE_LONGEST)) return;
  endpoint->throttled = 0;
  for (struct peer *peer = endpoint->peers; peer; peer = peer->next)
    if (peer->throttled && peer->wsi) {
      peer->throttled = 0;
      lws_rx_flow_control(peer->wsi, 1);
    }
}

static void look_again(lws_sorted_usec_list_t *list) {
  rowe_endpoint *endpoint = lws_container_of(list, rowe_endpoint, again);
  pthread_mutex_lock(&endpoint->lock);
  look_for_room(endpoint);
  if (endpoint->throttled) lws_sul_schedule(endpoint->context, 0, &endpoint->again, look_again, 100000);
  pthread_mutex_unlock(&endpoint->lock);
}

/* Do what other threads asked for. */
static void work(rowe_endpoint *endpoint) {
  pthread_mutex_lock(&endpoint->lock);
  if (endpoint->listening == 1) {
    pthread_mutex_unlock(&endpoint->lock);
    listen_now(endpoint);
    pthread_mutex_lock(&endpoint->lock);
  }
  look_for_room(endpoint);
  for (struct peer *peer = endpoint->peers; peer; peer = peer->next) {
    if (peer->wanted) {
      peer->wanted = 0;
      lws_sul_schedule(endpoint->context, 0, &peer->retry, retry, 1);
    }
    if (peer->wsi && peer->queue.count) lws_callback_on_writable(peer->wsi);
  }
  pthread_mutex_unlock(&endpoint->lock);
}

/* Whether bytes of a message that was sent have not left yet. */
static int leaving(rowe_endpoint *endpoint) {
  int found = 0;
  for (struct peer *peer = endpoint->peers; peer; peer = peer->next)
    if (peer->wsi && lws_partial_buffered(peer->wsi)) found = 1;
  return found;
}

void *rowe_serve(void *given) {
  rowe_endpoint *endpoint = given;
  int closing = 0;
  while (!closing && lws_service(endpoint->context, 0) >= 0) {
    pthread_mutex_lock(&endpoint->lock);
    closing = endpoint->closing;
    pthread_mutex_unlock(&endpoint->lock);
    work(endpoint);
  }
  for (double end = rowe_now() + FAREWELL; leaving(endpoint) && rowe_now() < end;) {
    lws_sul_schedule(endpoint->context, 0, &endpoint->again, look_again, 10000);
    lws_service(endpoint->context, 0);
  }
  lws_sul_schedule(endpoint->context, 0, &endpoint->again, look_again, LWS_SET_TIMER_USEC_CANCEL);
  for (struct peer *peer = endpoint->peers; peer; peer = peer->next)
    lws_sul_schedule(endpoint->context, 0, &peer->retry, retry, LWS_SET_TIMER_USEC_CANCEL);
  lws_context_destroy(endpoint->context);
  pthread_mutex_lock(&endpoint->lock);
  while (endpoint->peers) rowe_remove_peer(endpoint->peers);
  pthread_mutex_unlock(&endpoint->lock);
  return NULL;
}

static void opened(struct peer *peer, struct lws *wsi) {
  pthread_mutex_lock(&peer->endpoint->lock);
  peer->wsi = wsi;
  peer->begun = rowe_now();
  peer->length = 0;
  peer->invalid = peer->told_late = 0;
  pthread_mutex_unlock(&peer->endpoint->lock);
  if (peer->told) fprintf(stderr, "rowe: %s: connected\n", peer->name);
  peer->told = 0;
  lws_callback_on_writable(wsi);
}

static void accepted(rowe_endpoint *endpoint, struct lws *wsi, const char *asked) {
  char address[64], name[ROWE_NAME + 80];
  lws_get_peer_simple(wsi, address, sizeof address);
  pthread_mutex_lock(&endpoint->lock);
  int number = ++endpoint->numbers;
  if (*asked) snprintf(name, sizeof name, "%s", asked);
  else snprintf(name, sizeof name, "%s:%d", address, number);
  for (struct peer *peer = endpoint->peers; peer; peer = peer->next)
    if (!strcmp(peer->name, name)) {
      snprintf(name, sizeof name, "%s:%d", *asked ? asked : address, number);
      break;
    }
  struct peer *peer = rowe_add_peer(endpoint, name);
  pthread_mutex_unlock(&endpoint->lock);
  lws_set_opaque_user_data(wsi, peer);
  if (peer) opened(peer, wsi);
}

static void lost(struct peer *peer) {
  rowe_endpoint *endpoint = peer->endpoint;
  pthread_mutex_lock(&endpoint->lock);
  peer->wsi = NULL;
  peer->throttled = 0;
  if (!peer->host) rowe_remove_peer(peer);
  pthread_mutex_unlock(&endpoint->lock);
}

/* Send what waits, as much as the socket takes. Return whether the connection still works. */
static int write_all(struct peer *peer, struct lws *wsi) {
  pthread_mutex_t *lock = &peer->endpoint->lock;
  int works = 1;
  pthread_mutex_lock(lock);
  while (works && !lws_send_pipe_choked(wsi)) {
    struct outgoing *message = (struct outgoing *)rowe_queue_take(&peer->queue);
    if (!message) break;
    char *begin = rowe_begin(message->text, message->item.expiry - rowe_now());
    size_t size = message->length + (size_t)(message->text - begin);
    works = lws_write(wsi, (unsigned char *)begin, size, LWS_WRITE_TEXT) >= (int)size;
    if (works) {
      message->queue = NULL;
      rowe_settle(message, SENT);
    } else {
      /* It is sent over the next connection, if there is one in time. */
      rowe_queue_put_first(&peer->queue, &message->item);
    }
  }
  if (works && peer->queue.count) lws_callback_on_writable(wsi);
  pthread_mutex_unlock(lock);
  return works;
}

/* Give a message to the call that waits for it. With the lock held. */
static void give(struct peer *peer, rowe_message *reply) {
  for (struct waiting *call = peer->endpoint->waiting; call; call = call->next)
    if (!strcmp(call->id, reply->in_reply_to) && !call->reply) {
      call->reply = reply;
      pthread_cond_broadcast(&peer->endpoint->changed);
      return;
    }
  if (!peer->told_late)
    fprintf(stderr, "rowe: %s: sent a reply that nobody waits for, or that came too late\n", peer->name);
  peer->told_late = 1;
  rowe_free(reply);
}

static void keep(struct peer *peer, struct lws *wsi, rowe_message *message, size_t size) {
  rowe_endpoint *endpoint = peer->endpoint;
  struct incoming *incoming = calloc(1, sizeof *incoming);
  if (!incoming) {
    rowe_free(message);
    return;
  }
  incoming->message = message;
  incoming->item.expiry = rowe_now() + message->time_to_live;
  incoming->item.weight = size;
  rowe_queue_put(&endpoint->inbox, &incoming->item);
  pthread_cond_signal(&endpoint->arrived);
  if (!rowe_queue_has_room(&endpoint->inbox, ROWE_LONGEST)) {
    if (!endpoint->throttled) lws_sul_schedule(endpoint->context, 0, &endpoint->again, look_again, 100000);
    endpoint->throttled = peer->throttled = 1;
    lws_rx_flow_control(wsi, 0);
  }
}

/* Take a whole message. Return whether the connection goes on. */
static int received(struct peer *peer, struct lws *wsi) {
  const char *why = "not a text frame";
  rowe_message *message = NULL;
  if (!lws_frame_is_binary(wsi))
    message = rowe_decode(peer->endpoint->parser, peer->text, peer->length, peer->name, &why);
  if (!message) {
    if (!peer->invalid++) fprintf(stderr, "rowe: %s: sent an invalid message: %s\n", peer->name, why);
    if (peer->invalid < ROWE_INVALID_MAX) return 1;
    lws_close_reason(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, (unsigned char *)"invalid messages", 16);
    return 0;
  }
  pthread_mutex_lock(&peer->endpoint->lock);
  if (message->in_reply_to) give(peer, message);
  else keep(peer, wsi, message, peer->length);
  pthread_mutex_unlock(&peer->endpoint->lock);
  return 1;
}

/* Take a part of a message. Return whether the connection goes on. */
static int received_part(struct peer *peer, struct lws *wsi, const void *part, size_t length) {
  if (lws_is_first_fragment(wsi)) peer->length = 0;
  if (peer->length + length > ROWE_LONGEST) {
    fprintf(stderr, "rowe: %s: a message is larger than %u bytes, so the connection ends\n", peer->name,
            ROWE_LONGEST);
    lws_close_reason(wsi, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE, NULL, 0);
    return 0;
  }
  if (!peer->text && !(peer->text = malloc(ROWE_LONGEST))) return 0;
  memcpy(peer->text + peer->length, part, length);
  peer->length += length;
  return lws_is_final_fragment(wsi) && !lws_remaining_packet_payload(wsi) ? received(peer, wsi) : 1;
}

int rowe_event(struct lws *wsi, enum lws_callback_reasons reason, void *user, void *in, size_t length) {
  struct peer *peer = lws_get_opaque_user_data(wsi);
  switch (reason) {
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION: {
      char argument[ROWE_NAME + 5];
      const char *asked = lws_get_urlarg_by_name(wsi, "name=", argument, sizeof argument);
      snprintf(user, ROWE_NAME, "%s", asked ? asked : "");
      return 0;
    }
    case LWS_CALLBACK_ESTABLISHED:
      accepted(lws_context_user(lws_get_context(wsi)), wsi, user);
      return 0;
    case LWS_CALLBACK_CLIENT_ESTABLISHED:
      opened(peer, wsi);
      return 0;
    case LWS_CALLBACK_RECEIVE:
    case LWS_CALLBACK_CLIENT_RECEIVE:
      return peer && received_part(peer, wsi, in, length) ? 0 : -1;
    case LWS_CALLBACK_SERVER_WRITEABLE:
    case LWS_CALLBACK_CLIENT_WRITEABLE:
      return !peer || write_all(peer, wsi) ? 0 : -1;
    case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
      if (!peer) return 0;
      if (!peer->told && !peer->endpoint->closing)
        fprintf(stderr, "rowe: %s: no connection, trying again: %s\n", peer->name, in ? (const char *)in : "");
      peer->told = 1;
      schedule(peer);
      return 0;
    case LWS_CALLBACK_CLIENT_CLOSED:
      if (!peer) return 0;
      /* A server that accepts and leaves at once is asked less and less often, too. */
      if (rowe_now() - peer->begun > PAUSES[peer->attempt < LAST_PAUSE ? peer->attempt : LAST_PAUSE]) peer->attempt = 0;
      lost(peer);
      schedule(peer);
      return 0;
    case LWS_CALLBACK_CLOSED:
      if (peer) lost(peer);
      lws_set_opaque_user_data(wsi, NULL);
      return 0;
    default:
      return 0;
  }
}
