/* A queue whose items expire: a list in order, and a wheel of buckets by the time of expiry. Every
 * operation takes constant time, amortized. The items are part of what they queue. */
#ifndef ROWE_QUEUE_H
#define ROWE_QUEUE_H

#include <stddef.h>

#define ROWE_CAPACITY 10000
#define ROWE_HEAVIEST (64u << 20) /* bytes */
#define ROWE_SLOTS 1024
#define ROWE_TICK 0.05 /* s */

struct rowe_item {
  struct rowe_item *before, *after;   /* in the order of arrival */
  struct rowe_item *earlier, *later;  /* in the same slot of the wheel */
  double expiry;                      /* by rowe_now() */
  size_t weight;                      /* bytes */
};

struct rowe_queue {
  struct rowe_item *first, *last;
  struct rowe_item *slots[ROWE_SLOTS];
  long tick;
  size_t count, weight;
  void (*drop)(struct rowe_item *); /* called with each item that expired */
};

/* Seconds by a clock that does not jump. */
double rowe_now(void);

void rowe_queue_init(struct rowe_queue *queue, void (*drop)(struct rowe_item *));
/* Whether an item of this weight has room now. */
int rowe_queue_has_room(struct rowe_queue *queue, size_t weight);
/* Append an item whose expiry and weight are set; without looking whether there is room. */
void rowe_queue_put(struct rowe_queue *queue, struct rowe_item *item);
/* Put an item back where it was taken from. */
void rowe_queue_put_first(struct rowe_queue *queue, struct rowe_item *item);
/* Remove and return the oldest item that has not expired; NULL if there is none. */
struct rowe_item *rowe_queue_take(struct rowe_queue *queue);
void rowe_queue_remove(struct rowe_queue *queue, struct rowe_item *item);
/* Drop all items. */
void rowe_queue_clear(struct rowe_queue *queue);

#endif
