/* <sys/random.h>; that of Emscripten before 3.1.11 does not include what it uses. */
#pragma GCC system_header /* include_next is an extension */

#include <stddef.h>
#include_next <sys/random.h>
