// Repeats on /echo the first three messages of /chatter, and ends.
#include <emscripten/val.h>

#include <cstdio>
#include <string>

using emscripten::val;

int main()
{
  const std::string in = "/chatter", out = "/echo", publisher = "publisher", subscriber = "subscriber";
  const val join = val::module_property("registerParticipant");
  const val leave = val::module_property("deregisterParticipant");
  const std::string reader = join(in, subscriber).as<std::string>();
  const std::string writer = join(out, publisher).as<std::string>();

  for (int count = 0; count < 3;) {
    const auto message = val::module_property("retrieveMessage")(in).await().as<std::string>();
    if (message.empty()) {
      continue;
    }
    std::fprintf(stderr, "\x1b[0m[INFO] [1700000000.500000000] [echo]: message %d\x1b[0m\n", ++count);
    val::module_property("publishMessage")(message, out);
  }

  leave(reader, subscriber);
  leave(writer, publisher);
  return 0;
}
