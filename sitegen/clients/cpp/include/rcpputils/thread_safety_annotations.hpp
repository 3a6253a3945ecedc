#pragma once

// Clang's analysis of locks is not made for the page; the words stay legal.
#define RCPPUTILS_TSA_GUARDED_BY(x)
#define RCPPUTILS_TSA_PT_GUARDED_BY(x)
#define RCPPUTILS_TSA_REQUIRES(...)
#define RCPPUTILS_TSA_ACQUIRE(...)
#define RCPPUTILS_TSA_RELEASE(...)
#define RCPPUTILS_TSA_EXCLUDES(...)
