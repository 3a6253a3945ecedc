// Create objects of classes by name. A page cannot load libraries: all classes are linked into the
// program, and the name of a library selects the classes that were registered with it.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "class_loader/exceptions.hpp"
#include "class_loader/visibility_control.hpp"

namespace class_loader
{

namespace impl
{

template<class Base>
struct Class
{
  std::string library;
  std::function<std::unique_ptr<Base>()> make;
};

template<class Base>
std::map<std::string, Class<Base>> & classes()
{
  // Never destroyed: nodes with static lifetime may still be created from it.
  static auto * classes = new std::map<std::string, Class<Base>>;
  return *classes;
}

inline std::set<std::string> & libraries()
{
  static auto * libraries = new std::set<std::string>;
  return *libraries;
}

template<class Derived, class Base>
struct Registration
{
  Registration(const char * name, const char * library)
  {
    libraries().insert(library);
    classes<Base>()[name] = {library, [] {return std::make_unique<Derived>();}};
  }
};

}  // namespace impl

/// The file name of a library.
inline std::string systemLibraryFormat(const std::string & library_name)
{
  return "lib" + library_name + ".so";
}

class ClassLoader
{
public:
  template<class Base>
  using DeleterType = std::function<void (Base *)>;
  template<class Base>
  using UniquePtr = std::unique_ptr<Base, std::function<void (Base *)>>;

  /// The classes of one library, given by its path as in dlopen(), or all classes if the path is
  /// empty. Throws LibraryLoadException if the program is not linked with the library.
  explicit ClassLoader(
    const std::string & library_path, bool ondemand_load_unload = false)
  : on_demand_(ondemand_load_unload), library_path_(library_path), library_(library_path.substr(library_path.rfind('/') + 1))
  {
    library_.erase(std::min(library_.find('.'), library_.size()));
    if (library_.rfind("lib", 0) == 0) {library_.erase(0, 3);}
    if (!library_.empty() && !impl::libraries().count(library_)) {
      throw LibraryLoadException(
              "Could not load library " + library_path + ": this program is not linked with it");
    }
  }

  std::string getLibraryPath() const {return library_path_;}
  bool isLibraryLoaded() const {return true;}
  bool isLibraryLoadedByAnyClassloader() const {return true;}
  bool isOnDemandLoadUnloadEnabled() const {return on_demand_;}
  void loadLibrary() {}
  int unloadLibrary() {return 0;}

  template<class Base>
  std::vector<std::string> getAvailableClasses() const
  {
    std::vector<std::string> names;
    for (const auto & [name, one] : impl::classes<Base>()) {
      if (has(one.library)) {names.push_back(name);}
    }
    return names;
  }
  template<class Base>
  bool isClassAvailable(const std::string & name) const
  {
    const auto found = impl::classes<Base>().find(name);
    return found != impl::classes<Base>().end() && has(found->second.library);
  }
  template<class Base>
  std::shared_ptr<Base> createInstance(const std::string & name) {return make<Base>(name);}
  template<class Base>
  std::shared_ptr<Base> createSharedInstance(const std::string & name) {return make<Base>(name);}
  template<class Base>
  UniquePtr<Base> createUniqueInstance(const std::string & name)
  {
    return UniquePtr<Base>(make<Base>(name).release(), [](Base * made) {delete made;});
  }
  template<class Base>
  Base * createUnmanagedInstance(const std::string & name) {return make<Base>(name).release();}

private:
  bool has(const std::string & library) const {return library_.empty() || library == library_;}

  template<class Base>
  std::unique_ptr<Base> make(const std::string & name) const
  {
    if (!isClassAvailable<Base>(name)) {
      throw CreateClassException("Could not create instance of type " + name);
    }
    return impl::classes<Base>().at(name).make();
  }

  bool on_demand_;
  std::string library_path_;
  std::string library_;
};

}  // namespace class_loader

#include "class_loader/register_macro.hpp"
