// Uses what is in libraries by its name. Each line is one check, which the test reads.
#include <dlfcn.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "rcpputils/shared_library.hpp"
#include "rcutils/shared_library.h"

extern "C" int stick(int a);

namespace
{

template<class Function>
Function * at(void * library, const char * name)
{
  return reinterpret_cast<Function *>(dlsym(library, name));
}

void opens(const char * path)
{
  void * library = dlopen(path, RTLD_NOW);
  std::printf(
    "%s %s, version %d: %g\n", at<const char *()>(library, "name")(),
    at<const char *()>(library, "call_name")(), *static_cast<int *>(dlsym(library, "version")),
    at<double(int, double)>(library, "use")(3, 0.5));
  std::printf("half: %s\n", dlsym(library, "half") ? "there" : dlerror());
  std::printf("closed %d\n", dlclose(library));
}

void opens_with_rcpputils()
{
  rcpputils::SharedLibrary hammer(rcpputils::find_library_path("hammer"));
  try {
    reinterpret_cast<void (*)(const std::string &)>(hammer.get_symbol("fail"))("broken");
  } catch (const std::runtime_error & error) {
    std::printf("thrown: %s\n", error.what());
  }
  try {
    hammer.get_symbol("length");
  } catch (const std::runtime_error & error) {
    std::printf("thrown: %s\n", error.what());
  }
}

void opens_with_rcutils()
{
  auto saw = rcutils_get_zero_initialized_shared_library();
  char file[16];
  std::printf("name %d\n", rcutils_get_platform_library_name("saw", file, sizeof(file), false));
  const auto loaded = rcutils_load_shared_library(&saw, file, rcutils_get_default_allocator());
  std::printf(
    "loaded %d %s %d\n", loaded, saw.library_path, rcutils_is_shared_library_loaded(&saw));
  auto * half = reinterpret_cast<float (*)(float, long long)>(rcutils_get_symbol(&saw, "half"));
  std::printf("half %g, more %d\n", half(3, 10), rcutils_has_symbol(&saw, "more"));
  std::printf("unloaded %d\n", rcutils_unload_shared_library(&saw));
}

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  opens("libhammer.so");
  opens("/opt/robot/lib/libsaw.so.1");
  std::printf("linked %d, by name %d\n", stick(1), at<int(int)>(dlopen(nullptr, 0), "stick")(4));
  const void * none = dlopen("libnone.so", RTLD_NOW);
  std::printf("none %d: %s\n", none != nullptr, dlerror());
  opens_with_rcpputils();
  opens_with_rcutils();
}
