// Uses libraries that are compiled for the page.
#include <joints/joints.hpp>
#include <tinyxml2.h>
#include <uuid/uuid.h>
#include <yaml-cpp/yaml.h>

#include <cstdio>
#include <cstring>
#include <string>

namespace
{
struct Farewell
{
  ~Farewell() {std::puts("and says so when it ends");}
};

// exit() ends the object that the reference keeps.
const Farewell & farewell = Farewell();
}  // namespace

void print_compiled()
{
  const YAML::Node map = YAML::Load("{image: map.pgm, origin: [-10, 0.5]}");
  std::printf("yaml-cpp reads %g\n", map["origin"][1].as<double>());
  try {
    YAML::Load("[1, 2");
  } catch (const YAML::Exception & error) {
    std::printf("and fails at line %d\n", error.mark.line + 1);
  }
  tinyxml2::XMLDocument document;
  document.Parse("<robot name='arm'/>");
  std::printf("TinyXML2 reads %s\n", document.RootElement()->Attribute("name"));
  uuid_t id;
  uuid_generate_random(id);
  char text[37];
  uuid_unparse(id, text);
  std::printf("libuuid writes %zu characters\n", std::strlen(text));
  std::printf("robot_joints %s turns %g\n", JOINTS_VERSION, joints::degrees(joints::kHalfTurn));
}
