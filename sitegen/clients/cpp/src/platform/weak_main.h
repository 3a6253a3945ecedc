/* Included first in sources of libraries that define main(): the program's own takes precedence. */
#define main __attribute__((weak)) main
