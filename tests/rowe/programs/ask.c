/* Send a request (JSON) to a server, and print its reply: `ask URL REQUEST`. */
#include <stdio.h>

#include "rowe.h"

int main(int count, char **arguments) {
  if (count < 3) return 2;
  rowe_endpoint *endpoint = rowe_open();
  struct json_object *request = json_tokener_parse(arguments[2]);
  rowe_message *reply;
  enum rowe_result result = rowe_connect(endpoint, arguments[1], NULL);
  if (!result) result = rowe_invoke(endpoint, NULL, request, 30, &reply);
  if (result) {
    fprintf(stderr, "%s\n", rowe_text(result));
  } else {
    puts(json_object_to_json_string_ext(reply->body, JSON_C_TO_STRING_PLAIN));
    rowe_free(reply);
  }
  json_object_put(request);
  rowe_close(endpoint);
  return result != ROWE_OK;
}
