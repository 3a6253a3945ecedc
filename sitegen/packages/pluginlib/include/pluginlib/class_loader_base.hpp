#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "pluginlib/detail/descriptions.hpp"
#include "pluginlib/exceptions.hpp"

namespace pluginlib
{

/// The part of a loader that does not depend on the base class of its plugins.
class ClassLoaderBase
{
public:
  ClassLoaderBase(std::string package, std::string base_class)
  : package_(std::move(package)), base_class_(std::move(base_class))
  {
    for (const auto & one : detail::descriptions()) {
      if (package_ == one.category && base_class_ == one.base) {classes_.push_back(one);}
    }
  }
  virtual ~ClassLoaderBase() = default;

  /// The names of all plugins in alphabetical order.
  std::vector<std::string> getDeclaredClasses() const
  {
    std::vector<std::string> names;
    for (const auto & one : classes_) {names.emplace_back(one.name);}
    std::sort(names.begin(), names.end());
    return names;
  }
  bool isClassAvailable(const std::string & lookup_name) const {return find(lookup_name);}
  std::string getBaseClassType() const {return base_class_;}

  /// These are empty for an unknown name.
  std::string getClassType(const std::string & lookup_name) const
  {
    return text(lookup_name, &detail::Description::type);
  }
  std::string getClassDescription(const std::string & lookup_name) const
  {
    return text(lookup_name, &detail::Description::text);
  }
  std::string getClassPackage(const std::string & lookup_name) const
  {
    return text(lookup_name, &detail::Description::package);
  }
  std::string getClassLibraryPath(const std::string & lookup_name) const
  {
    return text(lookup_name, &detail::Description::library);
  }
  std::string getPluginManifestPath(const std::string & lookup_name) const
  {
    return text(lookup_name, &detail::Description::manifest);
  }
  /// The last part of a name: Square of polygon_plugins::Square or polygon_plugins/Square.
  std::string getName(const std::string & lookup_name) const
  {
    return lookup_name.substr(lookup_name.find_last_of("/:") + 1);
  }
  std::vector<std::string> getPluginXmlPaths() const
  {
    std::vector<std::string> paths;
    for (const auto & one : classes_) {paths.emplace_back(one.manifest);}
    return without_doubles(std::move(paths));
  }
  std::vector<std::string> getRegisteredLibraries() const
  {
    std::vector<std::string> paths;
    for (const auto & one : classes_) {paths.emplace_back(one.library);}
    return without_doubles(std::move(paths));
  }

  /// A page cannot load libraries: all linked plugins are available.
  bool isClassLoaded(const std::string & lookup_name) const {return find(lookup_name);}
  void loadLibraryForClass(const std::string & lookup_name) {require(lookup_name);}
  int unloadLibraryForClass(const std::string & lookup_name)
  {
    if (!find(lookup_name)) {throw LibraryUnloadException(unknown(lookup_name));}
    return 0;
  }
  void refreshDeclaredClasses() {}

protected:
  /// The class of a plugin; throws LibraryLoadException.
  std::string require(const std::string & lookup_name) const
  {
    if (const auto found = find(lookup_name)) {return found->type;}
    throw LibraryLoadException(unknown(lookup_name));
  }

private:
  const detail::Description * find(const std::string & lookup_name) const
  {
    for (const auto & one : classes_) {
      if (lookup_name == one.name) {return &one;}
    }
    return nullptr;
  }
  std::string text(
    const std::string & lookup_name, const char * const detail::Description::* field) const
  {
    const auto found = find(lookup_name);
    return found ? found->*field : "";
  }
  std::string unknown(const std::string & lookup_name) const
  {
    std::string message = "According to the loaded plugin descriptions the class " + lookup_name +
      " with base class type " + base_class_ + " does not exist. Declared types are ";
    for (const auto & name : getDeclaredClasses()) {message += " " + name;}
    return message;
  }
  static std::vector<std::string> without_doubles(std::vector<std::string> all)
  {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  std::string package_;
  std::string base_class_;
  std::vector<detail::Description> classes_;
};

}  // namespace pluginlib
