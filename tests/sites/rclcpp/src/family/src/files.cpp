// Files of parameters: read as maps, by the parser's own functions, and set for a node.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "rcl_yaml_param_parser/parser.h"
#include "rclcpp/parameter_map.hpp"
#include "rclcpp/rclcpp.hpp"

static void show(std::vector<rclcpp::Parameter> parameters)
{
  std::stable_sort(
    parameters.begin(), parameters.end(),
    [](const auto & a, const auto & b) {return a.get_name() < b.get_name();});
  for (const auto & one : parameters) {
    std::printf(
      "%s %s <%s>\n", one.get_name().c_str(), one.get_type_name().c_str(),
      one.value_to_string().c_str());
  }
}

template<class Call>
void attempt(Call call)
{
  try {
    call();
  } catch (const std::exception & error) {
    std::printf("refused: %s\n", error.what());
  }
}

static void parse(const std::string & arms)
{
  rcl_params_t * params = rcl_yaml_node_struct_init(rcutils_get_default_allocator());
  std::printf("file %d: ", rcl_parse_yaml_file(arms.c_str(), params));
  for (std::size_t n = 0; n < params->num_nodes; ++n) {
    std::printf("%s %zu ", params->node_names[n], params->params[n].num_params);
  }
  std::printf("\nvalue %d", rcl_parse_yaml_value("arm/left", "limits.low", "[.1, 2e-1]", params));
  const auto * low = rcl_yaml_node_struct_get("arm/left", "limits.low", params);
  std::printf(" %d %.1f\n", low->integer_value == nullptr, low->double_array_value->values[1]);
  for (const char * wrong : {"[1, true]", "a: b: c", "*other", "'open", "[1", ""}) {
    const bool done = rcl_parse_yaml_value("arm", "wrong", wrong, params);
    const std::string error = rcl_get_error_string().str;
    std::printf("%d %s\n", done, error.substr(0, error.find(", at")).c_str());
    rcl_reset_error();
  }
  std::printf("map %zu\n", rclcpp::parameter_map_from(params, "/arm/left").at("/arm/left").size());
  rcl_yaml_node_struct_fini(params);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const std::string arms =
    ament_index_cpp::get_package_share_directory("family") + "/config/arms.yaml";
  show(rclcpp::parameter_map_from_yaml_file(arms, "/arm/left").at("/arm/left"));
  std::printf("nodes %zu\n", rclcpp::parameter_map_from_yaml_file(arms).size());
  attempt([&] {rclcpp::parameter_map_from_yaml_file(arms + "x");});
  parse(arms);

  auto right = std::make_shared<rclcpp::Node>("right", "arm");
  right->declare_parameter("name", "none");
  right->declare_parameter("text", "none");
  right->declare_parameter("grip", 0.0);
  rclcpp::SyncParametersClient client(right);
  for (const auto & result : client.load_parameters(arms)) {
    std::printf("%d %s\n", result.successful, result.reason.c_str());
  }
  show(right->get_parameters({"name", "grip"}));
  rclcpp::ParameterMap map;
  map["/*/right"].emplace_back("name", "mapped");
  client.load_parameters(map);
  show(right->get_parameters({"name"}));
  attempt([&] {client.load_parameters(rclcpp::ParameterMap{{"/left", map["/*/right"]}});});
  std::puts("done");
}
