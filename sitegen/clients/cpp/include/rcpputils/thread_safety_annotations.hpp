#pragma once

// Clang's thread safety analysis is not used for pages; the annotations have no effect.
#define RCPPUTILS_TSA_GUARDED_BY(x)
#define RCPPUTILS_TSA_PT_GUARDED_BY(x)
#define RCPPUTILS_TSA_REQUIRES(...)
#define RCPPUTILS_TSA_ACQUIRE(...)
#define RCPPUTILS_TSA_RELEASE(...)
#define RCPPUTILS_TSA_EXCLUDES(...)
