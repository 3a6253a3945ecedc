/* The part of Linux's headers that ordinary programs use. */
#include <limits.h>
