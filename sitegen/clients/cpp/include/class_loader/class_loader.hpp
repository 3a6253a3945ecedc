// Classes by their names. There are no libraries to load in a page: all that a program was linked with
// is there.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace class_loader
{

class ClassLoaderException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class CreateClassException : public ClassLoaderException
{
public:
  using ClassLoaderException::ClassLoaderException;
};

namespace impl
{

template<class Base>
std::map<std::string, std::function<std::unique_ptr<Base>()>> & classes()
{
  // Never destroyed: nodes with static lifetime may still be made of them.
  static auto * classes = new std::map<std::string, std::function<std::unique_ptr<Base>()>>;
  return *classes;
}

template<class Derived, class Base>
struct Registration
{
  explicit Registration(const char * name)
  {
    classes<Base>()[name] = [] {return std::make_unique<Derived>();};
  }
};

}  // namespace impl

class ClassLoader
{
public:
  template<class Base>
  using UniquePtr = std::unique_ptr<Base, std::function<void (Base *)>>;

  explicit ClassLoader(const std::string & library_path, bool = false)
  : library_path_(library_path) {}

  std::string getLibraryPath() const {return library_path_;}
  bool isLibraryLoaded() const {return true;}
  void loadLibrary() {}
  int unloadLibrary() {return 0;}

  template<class Base>
  std::vector<std::string> getAvailableClasses() const
  {
    std::vector<std::string> names;
    for (const auto & [name, make] : impl::classes<Base>()) {names.push_back(name);}
    return names;
  }
  template<class Base>
  bool isClassAvailable(const std::string & name) const
  {
    return impl::classes<Base>().count(name) != 0;
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

private:
  template<class Base>
  static std::unique_ptr<Base> make(const std::string & name)
  {
    const auto found = impl::classes<Base>().find(name);
    if (found == impl::classes<Base>().end()) {
      throw CreateClassException("Could not create instance of type " + name);
    }
    return found->second();
  }

  std::string library_path_;
};

}  // namespace class_loader

#include "class_loader/register_macro.hpp"
