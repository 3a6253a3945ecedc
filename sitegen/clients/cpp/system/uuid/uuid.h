#pragma once

#include_next <uuid/uuid.h>

// What Emscripten's libuuid lacks. Its uuid_generate() makes random ones, as a page has no network
// address to make others from.
static inline void uuid_generate_random(uuid_t out) {uuid_generate(out);}
static inline void uuid_generate_time(uuid_t out) {uuid_generate(out);}
static inline int uuid_generate_time_safe(uuid_t out)
{
  uuid_generate(out);
  return -1;  // not one that a clock makes unique
}
