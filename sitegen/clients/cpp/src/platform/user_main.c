/* C may name main(), which C++ forbids. */
#include <emscripten.h>

int main(int argc, char ** argv);

int ros_user_main(int argc, char ** argv)
{
  return main(argc, argv);
}
