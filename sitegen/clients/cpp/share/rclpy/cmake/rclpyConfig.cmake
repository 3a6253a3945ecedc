# For packages with nodes in both languages: their C++ nodes need nothing of it.
include_guard(GLOBAL)
