// The functions of <dlfcn.h>. All libraries are linked into the program, and the names of their
// functions are not kept, so none can be opened.
#include <dlfcn.h>

#include <string>
#include <utility>

namespace
{

std::string & message()
{
  static std::string message;
  return message;
}

/// Whether there is an error that dlerror() has not returned.
bool is_new = false;

void fail(std::string text)
{
  message() = std::move(text);
  is_new = true;
}

}  // namespace

extern "C" {

void * dlopen(const char * path, int)
{
  fail(
    (path ? std::string(path) : "the program") +
    ": cannot open: a page cannot load libraries; use pluginlib or class_loader, which find the "
    "classes that are linked into the program");
  return nullptr;
}

void * dlsym(void *, const char * name)
{
  fail(std::string(name) + ": undefined symbol: a page cannot find functions by name");
  return nullptr;
}

int dlclose(void *)
{
  fail("not a library that was opened");
  return -1;
}

int dladdr(const void *, Dl_info *) {return 0;}

char * dlerror(void) {return std::exchange(is_new, false) ? message().data() : nullptr;}

}
