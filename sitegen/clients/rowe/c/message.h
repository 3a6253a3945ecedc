/* Messages as JSON text, and their three fields that rowe itself reads. */
#ifndef ROWE_MESSAGE_H
#define ROWE_MESSAGE_H

#include <stddef.h>

#include "rowe.h"

#define ROWE_LONGEST (1u << 20) /* bytes of a message */
#define ROWE_DEEPEST 100        /* objects and arrays in each other */
#define ROWE_TIME_ROOM 48       /* bytes that the field time_to_live takes at most */

/* Return the text of a message after its '{', in a new block that has `room` bytes before it; NULL if
 * it is invalid. `field` and `value` name one field of rowe, or are NULL. */
char *rowe_encode(struct json_object *body, const char *field, const char *value, size_t room, size_t *length);

/* Write '{' and the time that is left directly before `text`, and return where the message begins. */
char *rowe_begin(char *text, double left);

/* Return a message, or NULL; then `why` says what is wrong. */
rowe_message *rowe_decode(struct json_tokener *parser, const char *text, size_t length, const char *peer,
                          const char **why);

#endif
