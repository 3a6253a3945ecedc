#define _POSIX_C_SOURCE 200809L
#include "message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const OWN[] = {"message_id", "in_reply_to", "time_to_live"};

/* Whether a value is JSON: not too deep, and without numbers that JSON has no text for. */
static int is_json(struct json_object *value, int depth) {
  if (json_object_is_type(value, json_type_double)) return isfinite(json_object_get_double(value));
  if (json_object_is_type(value, json_type_object)) {
    if (depth >= ROWE_DEEPEST) return 0;
    json_object_object_foreach(value, key, inner) {
      (void)key;
      if (!is_json(inner, depth + 1)) return 0;
    }
  } else if (json_object_is_type(value, json_type_array)) {
    if (depth >= ROWE_DEEPEST) return 0;
    for (size_t i = 0; i < json_object_array_length(value); i++)
      if (!is_json(json_object_array_get_idx(value, i), depth + 1)) return 0;
  }
  return 1;
}

/* Whether the bytes are UTF-8. A WebSocket with others would be closed by the other side. */
static int is_utf8(const char *text, size_t length) {
  const unsigned char *at = (const unsigned char *)text, *end = at + length;
  while (at < end) {
    int more = *at < 0x80 ? 0 : *at >= 0xc2 && *at < 0xe0 ? 1 : *at >= 0xe0 && *at < 0xf0 ? 2 : *at >= 0xf0 && *at < 0xf5 ? 3 : -1;
    if (more < 0 || end - at <= more) return 0;
    if ((*at == 0xe0 && at[1] < 0xa0) || (*at == 0xed && at[1] > 0x9f) || (*at == 0xf0 && at[1] < 0x90) ||
        (*at == 0xf4 && at[1] > 0x8f))
      return 0;
    for (at++; more > 0; more--, at++)
      if ((*at & 0xc0) != 0x80) return 0;
  }
  return 1;
}

char *rowe_encode(struct json_object *body, const char *field, const char *value, size_t room, size_t *length) {
  if (!json_object_is_type(body, json_type_object) || !is_json(body, 0)) return NULL;
  for (size_t i = 0; i < sizeof OWN / sizeof *OWN; i++)
    if (json_object_object_get_ex(body, OWN[i], NULL)) return NULL;
  size_t size;
  const char *text = json_object_to_json_string_length(
      body, JSON_C_TO_STRING_PLAIN | JSON_C_TO_STRING_NOSLASHESCAPE, &size);
  if (!text || size > ROWE_LONGEST || !is_utf8(text, size)) return NULL;
  /* A name of rowe's own, an id of another program, quotes and a comma. */
  struct json_object *quoted = field ? json_object_new_string(value) : NULL;
  const char *shown = field ? json_object_to_json_string_ext(quoted, JSON_C_TO_STRING_PLAIN) : "";
  size_t extra = field ? strlen(field) + strlen(shown) + 4 : 0;
  char *block = malloc(room + extra + size + 1);
  if (block) {
    char *at = block + room;
    if (field) at += sprintf(at, "\"%s\":%s%s", field, shown, size > 2 ? "," : "");
    memcpy(at, text + 1, size); /* with the 0 at its end */
    *length = (size_t)(at - block) - room + size - 1;
  }
  if (quoted) json_object_put(quoted);
  if (block && *length >= ROWE_LONGEST) {
    free(block);
    block = NULL;
  }
  return block;
}

char *rowe_begin(char *text, double left) {
  char field[ROWE_TIME_ROOM];
  int size = 1;
  strcpy(field, "{");
  if (left < 1e9) {
    /* Not printf with %f: a program may have a locale that writes 0,5. */
    long micros = left > 0 ? (long)(left * 1e6) : 0;
    size = snprintf(field, sizeof field, "{\"time_to_live\":%ld.%06ld%s", micros / 1000000, micros % 1000000,
                    *text == '}' ? "" : ",");
  }
  memcpy(text - size, field, (size_t)size);
  return text - size;
}

/* Take a field of rowe with text out of a body. Return whether it is valid or absent. */
static int take_text(struct json_object *body, const char *name, char **found) {
  struct json_object *value;
  if (!json_object_object_get_ex(body, name, &value)) return 1;
  if (value && !json_object_is_type(value, json_type_string)) return 0;
  if (value) *found = strdup(json_object_get_string(value));
  json_object_object_del(body, name);
  return 1;
}

static int take_seconds(struct json_object *body, double *found) {
  struct json_object *value;
  if (!json_object_object_get_ex(body, "time_to_live", &value)) return 1;
  if (!json_object_is_type(value, json_type_int) && !json_object_is_type(value, json_type_double)) return 0;
  *found = json_object_get_double(value);
  json_object_object_del(body, "time_to_live");
  return *found >= 0;
}

rowe_message *rowe_decode(struct json_tokener *parser, const char *text, size_t length, const char *peer,
                          const char **why) {
  json_tokener_reset(parser);
  struct json_object *body = json_tokener_parse_ex(parser, text, (int)length);
  enum json_tokener_error error = json_tokener_get_error(parser);
  *why = NULL;
  if (error == json_tokener_error_depth)
    *why = "nested too deeply";
  else if (error != json_tokener_success || json_tokener_get_parse_end(parser) != length)
    *why = "not valid JSON";
  else if (!json_object_is_type(body, json_type_object))
    *why = "not a JSON object";
  else if (!is_json(body, 0))
    *why = "not valid JSON: a number is not finite, or nested too deeply";
  rowe_message *message = *why ? NULL : calloc(1, sizeof *message);
  if (!message) {
    json_object_put(body);
    return NULL;
  }
  message->body = body;
  message->peer = strdup(peer);
  message->time_to_live = ROWE_FOREVER;
  if (!take_text(body, "message_id", &message->message_id))
    *why = "message_id: must be text";
  else if (!take_text(body, "in_reply_to", &message->in_reply_to))
    *why = "in_reply_to: must be text";
  else if (!take_seconds(body, &message->time_to_live))
    *why = "time_to_live: must be a number of seconds, 0 or more";
  if (!*why) return message;
  rowe_free(message);
  return NULL;
}

void rowe_free(rowe_message *message) {
  if (!message) return;
  json_object_put(message->body);
  free(message->peer);
  free(message->message_id);
  free(message->in_reply_to);
  free(message);
}
