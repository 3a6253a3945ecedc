#pragma once

#include "class_loader/class_loader.hpp"

#ifndef SITEGEN_LIBRARY
#define SITEGEN_LIBRARY ""
#endif

#define CLASS_LOADER_JOIN_(first, second) first ## second
#define CLASS_LOADER_JOIN(first, second) CLASS_LOADER_JOIN_(first, second)

/// Upstream prints the message when the class is registered; here it is not printed.
#define CLASS_LOADER_REGISTER_CLASS_WITH_MESSAGE(Derived, Base, Message) \
  CLASS_LOADER_REGISTER_CLASS(Derived, Base)

#define CLASS_LOADER_REGISTER_CLASS(Derived, Base) \
  namespace \
  { \
  const class_loader::impl::Registration<Derived, Base> \
  CLASS_LOADER_JOIN(registration_, __COUNTER__)(#Derived, SITEGEN_LIBRARY); \
  }
