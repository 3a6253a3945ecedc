// <emscripten/fiber.h>, which coroutine libraries include within extern "C", where the templates of
// <emscripten.h> do not compile.
#pragma once
#pragma GCC system_header  // include_next is an extension

#ifdef __cplusplus
extern "C++" {
#endif
#include <emscripten/emscripten.h>
#ifdef __cplusplus
}
#endif

#include_next <emscripten/fiber.h>
