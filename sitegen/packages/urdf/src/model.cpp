#include "urdf/model.h"

#include <cstdio>
#include <fstream>
#include <iterator>

#include "urdf_parser/urdf_parser.h"

namespace urdf
{

bool Model::initFile(const std::string & filename)
{
  std::ifstream file(filename);
  if (!file) {
    std::fprintf(stderr, "Could not open file [%s] for parsing.\n", filename.c_str());
    return false;
  }
  return initString({std::istreambuf_iterator<char>(file), {}});
}

bool Model::initString(const std::string & xml)
{
  const auto model = parseURDF(xml);  // prints the error
  if (!model) {
    return false;
  }
  ModelInterface::operator=(*model);
  return true;
}

}  // namespace urdf
