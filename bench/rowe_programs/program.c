/* Measure rowe in C: `serve`, or `play PORT TURNS`, which prints a delay (ms) and a rate (/s). */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "rowe.h"

#define BATCH 1000

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + (double)time.tv_nsec / 1e9;
}

static int serve(void) {
  rowe_endpoint *endpoint = rowe_open_local_endpoint(0);
  printf("%d\n", rowe_port(endpoint));
  fflush(stdout);
  rowe_message *message;
  while ((message = rowe_receive(endpoint, ROWE_FOREVER))) {
    if (message->message_id) rowe_async_reply(endpoint, message, message->body, ROWE_FOREVER);
    rowe_free(message);
  }
  return 0;
}

static int ask(rowe_endpoint *endpoint, struct json_object *body, double timeout) {
  rowe_message *reply;
  if (rowe_invoke(endpoint, NULL, body, timeout, &reply)) return 0;
  rowe_free(reply);
  return 1;
}

static int compare(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static int play(int port, int turns) {
  rowe_endpoint *endpoint = rowe_open_remote_endpoint("127.0.0.1", port);
  struct json_object *body = json_tokener_parse("{\"topic\": \"speed\", \"x\": 0.25}");
  char text[61];
  memset(text, 'x', 60);
  text[60] = 0;
  json_object_object_add(body, "text", json_object_new_string(text));
  double *delays = calloc((size_t)turns + 50, sizeof *delays);
  for (int turn = 0; turn < turns + 50; turn++) {
    double begun = now();
    if (!ask(endpoint, body, 5)) return 1;
    delays[turn] = now() - begun;
  }
  qsort(delays + 50, (size_t)turns, sizeof *delays, compare);
  int batches = turns / 50 > 1 ? turns / 50 : 1;
  double begun = now();
  for (int batch = 0; batch < batches; batch++) {
    for (int count = 0; count < BATCH; count++)
      if (rowe_async_send(endpoint, NULL, body, ROWE_FOREVER)) return 1;
    if (!ask(endpoint, body, 60)) return 1;
  }
  double rate = batches * (BATCH + 1) / (now() - begun);
  printf("[%f, %f]\n", delays[50 + turns / 2] * 1e3, rate);
  free(delays);
  json_object_put(body);
  rowe_close(endpoint);
  return 0;
}

int main(int count, char **arguments) {
  if (count < 2) return 2;
  return strcmp(arguments[1], "play") ? serve() : play(atoi(arguments[2]), atoi(arguments[3]));
}
