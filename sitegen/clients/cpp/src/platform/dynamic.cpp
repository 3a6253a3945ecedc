// The functions of <dlfcn.h> and of rcutils that open libraries. All libraries are linked into the
// program. For programs that call these functions, nodes/cpp/loadable.py makes a table of the C
// functions and variables in them.
#include <dlfcn.h>

#include <cstdio>
#include <cstring>
#include <string_view>

#include "rcutils/error_handling.h"
#include "rcutils/shared_library.h"

extern "C" {

/// A symbol of a library, such as "libtools". One without an address stands for the library.
struct Symbol
{
  const char * library;
  const char * name;
  const void * address;
};

/// Ends with a symbol of no library; null if the program is linked without a table.
extern const Symbol sitegen_symbols[] __attribute__((weak));

/// Set what dlerror() returns next: a function of the C library.
void __dl_seterr(const char * format, ...);

}

namespace
{

const Symbol kProgram = {"", "", nullptr};

/// The first symbol for which `matches` returns true, or null.
template<class Matches>
const Symbol * find(Matches matches)
{
  const Symbol * symbol = sitegen_symbols;
  for (; symbol && symbol->library; ++symbol) {
    if (matches(*symbol)) {return symbol;}
  }
  return nullptr;
}

/// The library of a handle: null for what is none, and empty for the whole program.
const char * library_of(const void * handle)
{
  if (handle == RTLD_DEFAULT || handle == RTLD_NEXT || handle == &kProgram) {return "";}
  const Symbol * found = find([handle](const Symbol & symbol) {return &symbol == handle;});
  return found ? found->library : nullptr;
}

}  // namespace

extern "C" {

void * dlopen(const char * path, int)
{
  if (!path) {return const_cast<Symbol *>(&kProgram);}
  std::string_view name(path);
  name.remove_prefix(name.rfind('/') + 1);
  name = name.substr(0, name.find(".so"));
  const Symbol * found = find([name](const Symbol & symbol) {return name == symbol.library;});
  if (!found) {
    __dl_seterr(
      "%s: cannot open: a page cannot load libraries, and the program is not linked with this one",
      path);
  }
  return const_cast<Symbol *>(found);
}

void * dlsym(void * handle, const char * name)
{
  const char * library = library_of(handle);
  const Symbol * found = library ? find(
    [library, name](const Symbol & symbol) {
      return symbol.address && std::strcmp(symbol.name, name) == 0 &&
             (!*library || std::strcmp(symbol.library, library) == 0);
    }) : nullptr;
  if (!library) {
    __dl_seterr("not a library that was opened");
  } else if (!found) {
    __dl_seterr(
      "undefined symbol: %s: no C function or variable of %s%s", name,
      *library ? library : "any library", *library ? ".so" : "");
  }
  return found ? const_cast<void *>(found->address) : nullptr;
}

int dlclose(void * handle)
{
  if (handle && library_of(handle)) {return 0;}
  __dl_seterr("not a library that was opened");
  return -1;
}

int dladdr(const void *, Dl_info *) {return 0;}

rcutils_shared_library_t rcutils_get_zero_initialized_shared_library(void) {return {};}

rcutils_ret_t rcutils_load_shared_library(
  rcutils_shared_library_t * library, const char * path, rcutils_allocator_t allocator)
{
  if (!library || library->lib_pointer || !path || !rcutils_allocator_is_valid(&allocator)) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  void * handle = dlopen(path, RTLD_LAZY);
  if (!handle) {
    RCUTILS_SET_ERROR_MSG(dlerror());
    return RCUTILS_RET_ERROR;
  }
  const std::size_t size = std::strlen(path) + 1;
  auto * copy = static_cast<char *>(allocator.allocate(size, allocator.state));
  if (!copy) {return RCUTILS_RET_BAD_ALLOC;}
  *library = {handle, static_cast<char *>(std::memcpy(copy, path, size)), allocator};
  return RCUTILS_RET_OK;
}

void * rcutils_get_symbol(const rcutils_shared_library_t * library, const char * name)
{
  if (!library || !library->lib_pointer || !name) {
    RCUTILS_SET_ERROR_MSG("invalid library or symbol name");
    return nullptr;
  }
  void * found = dlsym(library->lib_pointer, name);
  if (!found) {RCUTILS_SET_ERROR_MSG(dlerror());}
  return found;
}

bool rcutils_has_symbol(const rcutils_shared_library_t * library, const char * name)
{
  return library && library->lib_pointer && name && dlsym(library->lib_pointer, name);
}

rcutils_ret_t rcutils_unload_shared_library(rcutils_shared_library_t * library)
{
  if (!library || !library->lib_pointer) {return RCUTILS_RET_INVALID_ARGUMENT;}
  library->allocator.deallocate(library->library_path, library->allocator.state);
  *library = {};
  return RCUTILS_RET_OK;
}

bool rcutils_is_shared_library_loaded(rcutils_shared_library_t * library)
{
  return library && library->lib_pointer;
}

rcutils_ret_t rcutils_get_platform_library_name(
  const char * name, char * file, unsigned int size, bool debug)
{
  if (!name || !file) {return RCUTILS_RET_INVALID_ARGUMENT;}
  const int written = std::snprintf(file, size, debug ? "lib%sd.so" : "lib%s.so", name);
  return written >= 0 && static_cast<unsigned int>(written) < size ?
         RCUTILS_RET_OK : RCUTILS_RET_ERROR;
}

}
