#include "behaviortree_cpp/factory.hpp"

#include <dlfcn.h>

#include <stdexcept>

void trees::Factory::registerFromPlugin(const std::string & path)
{
  void * library = dlopen(path.c_str(), RTLD_LOCAL | RTLD_NOW);
  void * function = library ? dlsym(library, "BT_RegisterNodesFromPlugin") : nullptr;
  if (!function) {throw std::runtime_error(dlerror());}
  reinterpret_cast<void (*)(Factory &)>(function)(*this);
}
