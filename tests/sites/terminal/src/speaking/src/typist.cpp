// Asks for a line, and ends with the exit code that it names.

#include <iostream>
#include <string>

int main(int argc, char * argv[])
{
  for (int index = 1; index < argc; ++index) {
    std::cout << "argument " << argv[index] << std::endl;
  }
  std::cout << "code?" << std::endl;
  int code = 0;
  if (!(std::cin >> code)) {
    return 7;
  }
  std::cout << "ending with " << code << std::endl;
  return code;
}
