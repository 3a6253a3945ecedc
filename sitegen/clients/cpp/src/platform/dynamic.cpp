// The functions of <dlfcn.h>. All libraries are linked into the program, and the names of their
// functions are not kept, so none can be opened.
#include <dlfcn.h>

extern "C" {

/// Set what dlerror() returns next: a function of the C library.
void __dl_seterr(const char * format, ...);

void * dlopen(const char * path, int)
{
  __dl_seterr(
    "%s: cannot open: a page cannot load libraries; use pluginlib or class_loader, which find the "
    "classes that are linked into the program", path ? path : "the program");
  return nullptr;
}

void * dlsym(void *, const char * name)
{
  __dl_seterr("%s: undefined symbol: a page cannot find functions by name", name);
  return nullptr;
}

int dlclose(void *)
{
  __dl_seterr("not a library that was opened");
  return -1;
}

int dladdr(const void *, Dl_info *) {return 0;}

}
