#include <robot_tools/export.h>

TOOLS_EXPORT int tools()
{
  return 3;
}

int main()
{
  return tools();
}
