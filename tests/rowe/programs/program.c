/* A program with rowe in C: `serve PORT`, or `play PORT`, which prints what it found. */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "rowe.h"

typedef struct json_object json;

static json *parse(const char *text) { return json_tokener_parse(text); }

static json *get(json *object, const char *key) {
  json *value = NULL;
  json_object_object_get_ex(object, key, &value);
  return value;
}

static int integer(json *object, const char *key) { return json_object_get_int(get(object, key)); }

static int is(json *body, const char *what) {
  const char *given = json_object_get_string(get(body, "do"));
  return given && !strcmp(given, what);
}

/* Make {key: number}. */
static json *number(const char *key, int value) {
  json *object = json_object_new_object();
  json_object_object_add(object, key, json_object_new_int(value));
  return object;
}

/* The message, freed after it was sent. */
static enum rowe_result sent(rowe_endpoint *endpoint, const char *to, json *body, double ttl) {
  enum rowe_result result = rowe_send(endpoint, to, body, ttl);
  json_object_put(body);
  return result;
}

static void replied(rowe_endpoint *endpoint, rowe_message *request, json *body) {
  rowe_reply(endpoint, request, body, ROWE_FOREVER);
  json_object_put(body);
}

static void show(const char *name, const char *value) {
  printf("[\"%s\", %s]\n", name, value);
  fflush(stdout);
}

static void show_number(const char *name, int value) {
  char text[20];
  snprintf(text, sizeof text, "%d", value);
  show(name, text);
}

static void serve_one(rowe_endpoint *endpoint, rowe_message *message) {
  json *body = message->body;
  if (is(body, "add")) {
    replied(endpoint, message, number("sum", integer(body, "a") + integer(body, "b")));
  } else if (is(body, "count")) {
    for (int i = 0; i < integer(body, "count"); i++) {
      json *each = number("number", i);
      rowe_async_send(endpoint, message->peer, each, ROWE_FOREVER);
      json_object_put(each);
    }
    json *done = parse("{\"done\": true}");
    rowe_async_reply(endpoint, message, done, ROWE_FOREVER);
    json_object_put(done);
  } else if (is(body, "ask")) {
    json *request = number("number", 20);
    rowe_message *reply;
    enum rowe_result result = rowe_invoke(endpoint, message->peer, request, 5, &reply);
    json_object_put(request);
    if (result) {
      puts(result == ROWE_GONE ? "gone" : rowe_text(result));
      fflush(stdout);
      return;
    }
    sent(endpoint, message->peer, number("got", integer(reply->body, "number")), ROWE_FOREVER);
    rowe_free(reply);
  } else if (is(body, "rest")) {
    double seconds = json_object_get_double(get(body, "seconds"));
    struct timespec rest = {(time_t)seconds, (long)((seconds - (long)seconds) * 1e9)};
    nanosleep(&rest, NULL);
  } else if (is(body, "broadcast")) {
    json *news = number("news", 1);
    replied(endpoint, message, number("peers", rowe_broadcast(endpoint, news, ROWE_FOREVER)));
    json_object_put(news);
  } else if (!is(body, "ignore")) {
    rowe_async_send(endpoint, message->peer, body, ROWE_FOREVER);
  }
}

static int serve(int port) {
  rowe_endpoint *endpoint = rowe_open_local_endpoint(port);
  if (!endpoint) return 1;
  printf("%d\n", rowe_port(endpoint));
  fflush(stdout);
  rowe_message *message;
  int end = 0;
  while (!end && (message = rowe_receive(endpoint, ROWE_FOREVER))) {
    end = is(message->body, "end");
    if (!end) serve_one(endpoint, message);
    rowe_free(message);
  }
  rowe_close(endpoint);
  return 0;
}

static rowe_message *taken(rowe_endpoint *endpoint) {
  rowe_message *message = rowe_receive(endpoint, 20);
  if (!message) abort();
  return message;
}

static int taken_number(rowe_endpoint *endpoint, const char *key) {
  rowe_message *message = taken(endpoint);
  int value = integer(message->body, key);
  rowe_free(message);
  return value;
}

/* Ask, and return a number of the reply; minus the result where there is none. */
static int asked(rowe_endpoint *endpoint, const char *text, double timeout, const char *key) {
  json *request = parse(text);
  rowe_message *reply;
  enum rowe_result result = rowe_invoke(endpoint, NULL, request, timeout, &reply);
  json_object_put(request);
  if (result) return -(int)result;
  int value = integer(reply->body, key);
  rowe_free(reply);
  return value;
}

struct asker {
  pthread_t thread;
  rowe_endpoint *endpoint;
  int first, right;
};

static void *ask(void *given) {
  struct asker *asker = given;
  for (int b = 0; b < 25; b++) {
    char text[80];
    snprintf(text, sizeof text, "{\"do\": \"add\", \"a\": %d, \"b\": %d}", asker->first, b);
    asker->right += asked(asker->endpoint, text, 5, "sum") == asker->first + b;
  }
  return NULL;
}

static void play_threads(rowe_endpoint *endpoint) {
  struct asker askers[4];
  int right = 0;
  for (int i = 0; i < 4; i++) {
    askers[i] = (struct asker){.endpoint = endpoint, .first = 100 * i};
    pthread_create(&askers[i].thread, NULL, ask, &askers[i]);
  }
  for (int i = 0; i < 4; i++) {
    pthread_join(askers[i].thread, NULL);
    right += askers[i].right;
  }
  show_number("threads", right);
}

static int play(int port) {
  rowe_endpoint *endpoint = rowe_open_remote_endpoint("127.0.0.1", port);
  show_number("sum", asked(endpoint, "{\"do\": \"add\", \"a\": 38, \"b\": 4}", 5, "sum"));

  asked(endpoint, "{\"do\": \"count\", \"count\": 100}", 5, "done");
  int order = 1;
  for (int i = 0; i < 100; i++) order = taken_number(endpoint, "number") == i && order;
  show("order", order ? "true" : "false");

  show("silence", asked(endpoint, "{\"do\": \"ignore\"}", 0.2, "") == -ROWE_TIMEOUT ? "\"timeout\"" : "null");

  sent(endpoint, NULL, parse("{\"do\": \"ask\"}"), ROWE_FOREVER);
  rowe_message *request = taken(endpoint);
  replied(endpoint, request, number("number", integer(request->body, "number") + 1));
  rowe_free(request);
  show_number("asked", taken_number(endpoint, "got"));

  sent(endpoint, NULL, parse("{\"do\": \"rest\", \"seconds\": 0.5}"), ROWE_FOREVER);
  sent(endpoint, NULL, number("echo", 1), 0.2);
  sent(endpoint, NULL, number("echo", 2), ROWE_FOREVER);
  show_number("expired", taken_number(endpoint, "echo"));

  sent(endpoint, NULL, parse("{\"text\": \"ü€😀\\n\", \"deep\": [[{\"a\": null}]], \"number\": -0.5, \"flag\": true}"), 5);
  rowe_message *echo = taken(endpoint);
  show("echo", json_object_to_json_string(echo->body));
  rowe_free(echo);

  char both[40];
  int peers = asked(endpoint, "{\"do\": \"broadcast\"}", 5, "peers");
  snprintf(both, sizeof both, "[%d, %d]", peers, taken_number(endpoint, "news"));
  show("broadcast", both);

  play_threads(endpoint);

  rowe_endpoint *alone = rowe_open();
  show("discarded", sent(alone, NULL, parse("{}"), 0.2) == ROWE_DISCARDED ? "false" : "true");
  rowe_close(alone);

  puts("leave");
  fflush(stdout);
  getchar();
  show("vanished", asked(endpoint, "{\"do\": \"ignore\"}", 0.5, "") == -ROWE_TIMEOUT ? "\"timeout\"" : "null");
  json *third = number("echo", 3);
  rowe_async_send(endpoint, NULL, third, ROWE_FOREVER);
  json_object_put(third);
  puts("return");
  fflush(stdout);
  show_number("returned", taken_number(endpoint, "echo"));
  rowe_close(endpoint);
  return 0;
}

int main(int count, char **arguments) {
  if (count < 3) return 2;
  int port = atoi(arguments[2]);
  return strcmp(arguments[1], "serve") ? play(port) : serve(port);
}
