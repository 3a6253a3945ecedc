/* Check the queue of rowe against a list, and print what an operation takes in a small and a large one (µs). */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "queue.h"

struct number {
  struct rowe_item item; /* must be first */
  int value;
};

static int dropped;

static void drop(struct rowe_item *item) {
  dropped++;
  free(item);
}

static struct number *add(struct rowe_queue *queue, int value, double ttl) {
  struct number *number = calloc(1, sizeof *number);
  number->value = value;
  number->item.expiry = rowe_now() + ttl;
  rowe_queue_put(queue, &number->item);
  return number;
}

static int take(struct rowe_queue *queue) {
  struct number *number = (struct number *)rowe_queue_take(queue);
  int value = number ? number->value : -1;
  free(number);
  return value;
}

/* Numbers in any order of operations; nothing expires. Return whether the queue has always agreed. */
static int agrees(void) {
  static struct rowe_queue queue;
  struct number *expected[1000] = {0};
  int count = 0;
  srand(7);
  rowe_queue_init(&queue, drop);
  for (int value = 0; value < 20000; value++) {
    if (count < 1000 && rand() % 2) {
      expected[count++] = add(&queue, value, rand() % 2 ? 60 + rand() % 100 : 1e10);
    } else if (count && rand() % 2) {
      int first = expected[0]->value;
      if (take(&queue) != first) return 0;
      memmove(expected, expected + 1, (size_t)--count * sizeof *expected);
    } else if (count) {
      int at = rand() % count;
      rowe_queue_remove(&queue, &expected[at]->item);
      free(expected[at]);
      memmove(expected + at, expected + at + 1, (size_t)(--count - at) * sizeof *expected);
    }
    if (queue.count != (size_t)count) return 0;
  }
  rowe_queue_clear(&queue);
  return queue.count == 0;
}

/* Those that expire leave from wherever they are, also after more than a turn of the wheel. */
static int expires(void) {
  static struct rowe_queue queue;
  struct timespec rest = {0, 250000000};
  dropped = 0;
  rowe_queue_init(&queue, drop);
  add(&queue, 1, 10);
  add(&queue, 2, 0.1);
  add(&queue, 3, 0.05 * ROWE_SLOTS + 0.1); /* in the same slot */
  add(&queue, 4, 0.1);
  nanosleep(&rest, NULL);
  int right = rowe_queue_has_room(&queue, 0) && queue.count == 2 && dropped == 2;
  right = take(&queue) == 1 && take(&queue) == 3 && right;
  add(&queue, 5, 0.001);
  nanosleep(&rest, NULL);
  return take(&queue) == -1 && right;
}

static double microseconds(int count) {
  static struct rowe_queue queue;
  rowe_queue_init(&queue, drop);
  for (int value = 0; value < count; value++) add(&queue, value, 100 + value % 1000);
  double best = 1e9;
  for (int turn = 0; turn < 20; turn++) {
    double begun = rowe_now();
    for (int i = 0; i < 1000; i++) {
      add(&queue, i, 100 + i);
      take(&queue);
    }
    double each = (rowe_now() - begun) / 2000 * 1e6;
    if (each < best) best = each;
  }
  rowe_queue_clear(&queue);
  return best;
}

int main(int count, char **arguments) {
  (void)arguments;
  int small = 10000, large = count > 1 ? 20000 : 1000000; /* fewer under valgrind */
  printf("[%s, %s, %f, %f]\n", agrees() ? "true" : "false", expires() ? "true" : "false", microseconds(small),
         microseconds(large));
  return 0;
}
