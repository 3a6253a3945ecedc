#define _POSIX_C_SOURCE 200809L
#include "queue.h"

#include <math.h>
#include <string.h>
#include <time.h>

double rowe_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + (double)now.tv_nsec / 1e9;
}

static long tick_of(double seconds) { return (long)floor(seconds / ROWE_TICK); }

static struct rowe_item **slot_of(struct rowe_queue *queue, double expiry) {
  return &queue->slots[tick_of(expiry) % ROWE_SLOTS];
}

/* Longer than a long can count ticks. */
static int expires(const struct rowe_item *item) { return item->expiry < 1e9; }

void rowe_queue_init(struct rowe_queue *queue, void (*drop)(struct rowe_item *)) {
  memset(queue, 0, sizeof *queue);
  queue->drop = drop;
  queue->tick = tick_of(rowe_now());
}

void rowe_queue_remove(struct rowe_queue *queue, struct rowe_item *item) {
  *(item->before ? &item->before->after : &queue->first) = item->after;
  *(item->after ? &item->after->before : &queue->last) = item->before;
  if (expires(item)) {
    *(item->earlier ? &item->earlier->later : slot_of(queue, item->expiry)) = item->later;
    if (item->later) item->later->earlier = item->earlier;
  }
  queue->count--;
  queue->weight -= item->weight;
}

/* Drop what expired in the ticks that passed. A slot has also items of later turns of the wheel. */
static void advance(struct rowe_queue *queue) {
  long now = tick_of(rowe_now());
  long passed = now - queue->tick;
  if (passed > ROWE_SLOTS) passed = ROWE_SLOTS;
  for (long tick = now - passed; tick < now; tick++) {
    struct rowe_item *next;
    for (struct rowe_item *item = queue->slots[tick % ROWE_SLOTS]; item; item = next) {
      next = item->later;
      if (tick_of(item->expiry) >= now) continue;
      rowe_queue_remove(queue, item);
      queue->drop(item);
    }
  }
  queue->tick = now;
}

int rowe_queue_has_room(struct rowe_queue *queue, size_t weight) {
  advance(queue);
  return !queue->count || (queue->count < ROWE_CAPACITY && queue->weight + weight <= ROWE_HEAVIEST);
}

static void add(struct rowe_queue *queue, struct rowe_item *item) {
  queue->count++;
  queue->weight += item->weight;
  if (!expires(item)) return;
  struct rowe_item **slot = slot_of(queue, item->expiry);
  item->earlier = NULL;
  item->later = *slot;
  if (*slot) (*slot)->earlier = item;
  *slot = item;
}

void rowe_queue_put(struct rowe_queue *queue, struct rowe_item *item) {
  advance(queue);
  item->before = queue->last;
  item->after = NULL;
  *(queue->last ? &queue->last->after : &queue->first) = item;
  queue->last = item;
  add(queue, item);
}

void rowe_queue_put_first(struct rowe_queue *queue, struct rowe_item *item) {
  advance(queue);
  item->before = NULL;
  item->after = queue->first;
  *(queue->first ? &queue->first->before : &queue->last) = item;
  queue->first = item;
  add(queue, item);
}

struct rowe_item *rowe_queue_take(struct rowe_queue *queue) {
  advance(queue);
  struct rowe_item *item;
  while ((item = queue->first)) {
    rowe_queue_remove(queue, item);
    if (item->expiry > rowe_now()) return item;
    queue->drop(item);
  }
  return NULL;
}

void rowe_queue_clear(struct rowe_queue *queue) {
  struct rowe_item *item;
  while ((item = queue->first)) {
    rowe_queue_remove(queue, item);
    queue->drop(item);
  }
}
