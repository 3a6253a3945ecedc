#pragma once

#include <memory>
#include <string>
#include <vector>

#include "class_loader/class_loader.hpp"
#include "pluginlib/class_loader_base.hpp"

namespace pluginlib
{

template<class T>
using UniquePtr = class_loader::ClassLoader::UniquePtr<T>;

/// Creates objects of the plugins that are linked into the program: those of its package and of the
/// packages that it depends on.
template<class T>
class ClassLoader : public ClassLoaderBase
{
public:
  ClassLoader(
    std::string package, std::string base_class, std::string = "plugin",
    std::vector<std::string> = {})
  : ClassLoaderBase(std::move(package), std::move(base_class)) {}

  /// These throw LibraryLoadException if no description has this name, and CreateClassException if
  /// no library registers the class.
  std::shared_ptr<T> createSharedInstance(const std::string & lookup_name)
  {
    return create([&](const std::string & type) {return loader_.createSharedInstance<T>(type);},
             lookup_name);
  }
  UniquePtr<T> createUniqueInstance(const std::string & lookup_name)
  {
    return create([&](const std::string & type) {return loader_.createUniqueInstance<T>(type);},
             lookup_name);
  }
  T * createUnmanagedInstance(const std::string & lookup_name)
  {
    return createUniqueInstance(lookup_name).release();
  }

private:
  template<class MakeT>
  auto create(MakeT && make, const std::string & lookup_name)
  {
    const std::string type = require(lookup_name);
    try {
      return make(type);
    } catch (const class_loader::CreateClassException & error) {
      throw CreateClassException(error.what());
    }
  }

  class_loader::ClassLoader loader_{""};
};

}  // namespace pluginlib
