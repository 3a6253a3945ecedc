// The descriptions of the plugins that are linked into a program, written by cmake/describe.py.
#pragma once

#include <initializer_list>
#include <vector>

namespace pluginlib
{
namespace detail
{

struct Description
{
  const char * category;  // the package that has the base class
  const char * name;      // by which it is looked up
  const char * type;
  const char * base;
  const char * package;
  const char * text;
  const char * library;
  const char * manifest;
};

inline std::vector<Description> & descriptions()
{
  static std::vector<Description> all;
  return all;
}

struct Registration
{
  Registration(std::initializer_list<Description> some)
  {
    descriptions().insert(descriptions().end(), some);
  }
};

}  // namespace detail
}  // namespace pluginlib
