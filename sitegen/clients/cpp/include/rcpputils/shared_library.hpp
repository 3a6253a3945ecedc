#pragma once

#include <dlfcn.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "rcpputils/find_library.hpp"

namespace rcpputils
{

/// A library that is linked into the program. The constructor throws std::runtime_error for others.
class SharedLibrary
{
public:
  explicit SharedLibrary(const std::string & library_path)
  : path_(library_path),
    handle_(dlopen(library_path.c_str(), RTLD_LAZY))
  {
    if (!handle_) {fail();}
  }
  SharedLibrary(const SharedLibrary &) = delete;
  SharedLibrary & operator=(const SharedLibrary &) = delete;
  virtual ~SharedLibrary()
  {
    if (handle_) {dlclose(handle_);}
  }

  void unload_library()
  {
    if (dlclose(std::exchange(handle_, nullptr)) != 0) {fail();}
  }
  bool has_symbol(const char * symbol_name) {return handle_ && dlsym(handle_, symbol_name);}
  bool has_symbol(const std::string & symbol_name) {return has_symbol(symbol_name.c_str());}
  /// Throws std::runtime_error if the library does not have it.
  void * get_symbol(const char * symbol_name)
  {
    void * found = dlsym(handle_, symbol_name);
    if (!found) {fail();}
    return found;
  }
  void * get_symbol(const std::string & symbol_name) {return get_symbol(symbol_name.c_str());}
  std::string get_library_path() {return path_;}

private:
  [[noreturn]] static void fail()
  {
    const char * reason = dlerror();
    throw std::runtime_error(reason ? reason : "unknown error");
  }

  std::string path_;
  void * handle_;
};

inline std::string get_platform_library_name(std::string library_name, bool debug = false)
{
  return filename_for_library(library_name + (debug ? "d" : ""));
}

}  // namespace rcpputils
