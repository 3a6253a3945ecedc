#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "class_loader/class_loader.hpp"

namespace class_loader
{

using LibraryPath = std::string;

/// Creates objects of the classes of several libraries, each of which the program is linked with.
class MultiLibraryClassLoader
{
public:
  explicit MultiLibraryClassLoader(bool enable_ondemand_loadunload)
  : on_demand_(enable_ondemand_loadunload) {}
  virtual ~MultiLibraryClassLoader() = default;

  /// These throw CreateClassException, and NoClassLoaderExistsException for a library that was not
  /// loaded.
  template<class Base>
  std::shared_ptr<Base> createInstance(const std::string & name)
  {
    return of_class<Base>(name).template createInstance<Base>(name);
  }
  template<class Base>
  std::shared_ptr<Base> createInstance(const std::string & name, const std::string & library_path)
  {
    return of_library(library_path).createInstance<Base>(name);
  }
  template<class Base>
  std::shared_ptr<Base> createSharedInstance(const std::string & name)
  {
    return createInstance<Base>(name);
  }
  template<class Base>
  std::shared_ptr<Base> createSharedInstance(
    const std::string & name, const std::string & library_path)
  {
    return createInstance<Base>(name, library_path);
  }
  template<class Base>
  ClassLoader::UniquePtr<Base> createUniqueInstance(const std::string & name)
  {
    return of_class<Base>(name).template createUniqueInstance<Base>(name);
  }
  template<class Base>
  ClassLoader::UniquePtr<Base> createUniqueInstance(
    const std::string & name, const std::string & library_path)
  {
    return of_library(library_path).createUniqueInstance<Base>(name);
  }
  template<class Base>
  Base * createUnmanagedInstance(const std::string & name)
  {
    return of_class<Base>(name).template createUnmanagedInstance<Base>(name);
  }
  template<class Base>
  Base * createUnmanagedInstance(const std::string & name, const std::string & library_path)
  {
    return of_library(library_path).createUnmanagedInstance<Base>(name);
  }

  template<class Base>
  bool isClassAvailable(const std::string & name) const {return find<Base>(name);}
  template<class Base>
  std::vector<std::string> getAvailableClasses() const
  {
    std::vector<std::string> all;
    for (const auto & [path, loader] : loaders_) {
      for (auto & name : loader->getAvailableClasses<Base>()) {all.push_back(name);}
    }
    return all;
  }
  template<class Base>
  std::vector<std::string> getAvailableClassesForLibrary(const std::string & library_path)
  {
    return of_library(library_path).getAvailableClasses<Base>();
  }

  bool isLibraryAvailable(const std::string & library_path) const
  {
    return loaders_.count(library_path);
  }
  std::vector<std::string> getRegisteredLibraries() const
  {
    std::vector<std::string> paths;
    for (const auto & [path, loader] : loaders_) {paths.push_back(path);}
    return paths;
  }
  /// Throws LibraryLoadException if the program is not linked with the library.
  void loadLibrary(const std::string & library_path)
  {
    if (isLibraryAvailable(library_path)) {return;}
    loaders_[library_path] = std::make_unique<ClassLoader>(library_path, on_demand_);
  }
  int unloadLibrary(const std::string & library_path)
  {
    loaders_.erase(library_path);
    return 0;
  }

private:
  template<class Base>
  ClassLoader * find(const std::string & name) const
  {
    for (const auto & [path, loader] : loaders_) {
      if (loader->isClassAvailable<Base>(name)) {return loader.get();}
    }
    return nullptr;
  }
  template<class Base>
  ClassLoader & of_class(const std::string & name) const
  {
    if (const auto loader = find<Base>(name)) {return *loader;}
    throw CreateClassException(
            "MultiLibraryClassLoader: no loaded library has the class " + name);
  }
  ClassLoader & of_library(const std::string & library_path) const
  {
    const auto found = loaders_.find(library_path);
    if (found != loaders_.end()) {return *found->second;}
    throw NoClassLoaderExistsException(
            "MultiLibraryClassLoader: the library " + library_path + " was not loaded");
  }

  bool on_demand_;
  std::map<LibraryPath, std::unique_ptr<ClassLoader>> loaders_;
};

}  // namespace class_loader
