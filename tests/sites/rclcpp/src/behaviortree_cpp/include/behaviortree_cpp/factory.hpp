// Nodes of trees that libraries register.
#pragma once

#include <string>
#include <vector>

namespace trees
{

class Factory
{
public:
  /// Open a library, whose nodes its function BT_RegisterNodesFromPlugin() adds to `names`.
  void registerFromPlugin(const std::string & path);

  std::vector<std::string> names;
};

}  // namespace trees

#ifdef BT_PLUGIN_EXPORT
#define BT_REGISTER_NODES(factory) \
  extern "C" void BT_RegisterNodesFromPlugin(trees::Factory & factory)
#else
#define BT_REGISTER_NODES(factory) static void BT_RegisterNodesFromPlugin(trees::Factory & factory)
#endif
