#ifndef RCL_YAML_PARAM_PARSER__PARSER_H_
#define RCL_YAML_PARAM_PARSER__PARSER_H_

#include "rcl_yaml_param_parser/types.h"

#ifdef __cplusplus
extern "C"
{
#endif

/* Null if there is no memory. */
rcl_params_t * rcl_yaml_node_struct_init(const rcutils_allocator_t allocator);

void rcl_yaml_node_struct_fini(rcl_params_t * params_st);

/* False, with an error set, for what is no file of parameters. */
bool rcl_parse_yaml_file(const char * file_path, rcl_params_t * params_st);

/* Reads one value as it would stand in a file. */
bool rcl_parse_yaml_value(
  const char * node_name, const char * param_name, const char * yaml_value,
  rcl_params_t * params_st);

/* The value of a parameter, which is made if it is not there. */
rcl_variant_t * rcl_yaml_node_struct_get(
  const char * node_name, const char * param_name, rcl_params_t * params_st);

#ifdef __cplusplus
}
#endif

#endif  /* RCL_YAML_PARAM_PARSER__PARSER_H_ */
