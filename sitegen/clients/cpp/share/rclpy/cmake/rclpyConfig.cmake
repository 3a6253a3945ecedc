# For packages with nodes in both languages: those in C++ need nothing of it.
include_guard(GLOBAL)
