#include <cstdio>
#include <stdexcept>
#include <string>

int length();

namespace
{

struct Loaded
{
  Loaded() {std::puts("hammer is there");}
} loaded;

}  // namespace

extern "C" {

int version = 3;

const char * name() {return "hammer";}

double use(int a, double b) {return a * b + length();}

void fail(const std::string & why) {throw std::runtime_error(why);}

}
